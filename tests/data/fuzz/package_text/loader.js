var Module = typeof Module !== 'undefined' ? Module : {};
(function() {
  var loadPackage = function(metadata) { fetchRemotePackage("assets.data", metadata['remote_package_size']); }
  loadPackage({"files": [{"filename": "/models/handedness.txt", "start": 0, "end": 11}, {"filename": "/models/palm_detection_full.tflite", "start": 11, "end": 2341291}, {"filename": "/models/palm_detection_lite.tflite", "start": 2341291, "end": 4326731}], "remote_package_size": 4326731});
})();
