// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

// What each reader does with a file of these bytes. Error is the only exception that may come out of a reader, and is
// caught here; whatever else comes out, a crash or an endless loop is a defect.
namespace fuzz {

/// Indexes a video and reads pictures in and out of order, small ones and glances among them.
void readVideo(std::string_view bytes);
/// The kept index of a video, with that video, which it need not fit.
void readIndex(std::string_view bytes);
/// Small pictures that are kept of a video: records in their file, and the pictures in them.
void readSmallPictures(std::string_view bytes);
/// The network of a TensorFlow Lite file.
void readNetwork(std::string_view bytes);
/// The same, run once where it is a sound one.
void runNetwork(std::string_view bytes);
/// Any table of a FlatBuffers file: the bytes say which fields are followed.
void readFlatBuffer(std::string_view bytes);
/// The package of the hand detector, packed with gzip or not yet.
void readArchive(std::string_view bytes);
/// The texts of that package: the loader, which says where networks are packed, and package.json.
void readPackageText(std::string_view bytes);
/// Variables of a MATLAB file, with all that is in them.
void readMatlab(std::string_view bytes);
/// An HDF5 file as a data frame of pandas, and as one of SLEAP.
void readHdf5(std::string_view bytes);
/// Names of columns as pandas keeps them.
void readPickle(std::string_view bytes);

} // namespace fuzz
