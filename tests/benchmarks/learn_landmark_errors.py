#!/usr/bin/python3
"""Learns the table of core/detection/landmark_spread.cpp from rendered hands with known joints.

  learn_landmark_errors.py BATCH DATASET AUTOLABEL.json...   (each made by: handlens-batch autolabel DATASET --sequence S --out FILE)

Per landmark: spread per axis in one picture (share of the square's side, by the median), bias in the joint's own frame (share of the palm's
length), and what is left per axis in space, mm. The
labels must be of a program whose table has no bias. --fold also learns from every second file and tries the table on the others.
Needs Debian's python3-numpy.
"""
import json, os, subprocess, sys, tempfile
import numpy as np

NAMES = ["wrist"] + [f + "_" + p for f, ps in [("thumb", ("cmc", "mcp", "ip", "tip"))] + [(f, ("mcp", "pip", "dip", "tip")) for f in ("index", "middle", "ring", "little")] for p in ps]
PALMAR = [0, 1, 2, 3, 5, 6, 9, 10, 13, 14, 17, 18]


def project(cam, X):
    K, R, t = (np.array(cam[k]) for k in ("K", "R", "t"))
    x = R @ X + t.ravel()
    return x[:2] / x[2] * [K[0, 0], K[1, 1]] + [K[0, 2], K[1, 2]]


def side_of_square(px):
    """As placeOf: twice the box of the palm's landmarks along the hand."""
    up = px[5] / 4 + px[13] / 4 + px[9] / 2 - px[0]
    up /= np.linalg.norm(up)
    p = np.array([px[i] for i in PALMAR])
    return 2 * max(np.ptp(p @ up), np.ptp(p @ [-up[1], up[0]]))


def frame_of(P, i, hand):
    """As landmarkFrame: y from the joint before, z away from the back of the hand, x to the thumb's side; and the palm's length."""
    y = P[9] - P[0] if i == 0 else P[i] - P[0 if i % 4 == 1 else i - 1]
    y = y / np.linalg.norm(y)
    across = (P[5] - P[17])
    z = np.cross(across, P[9] - P[0]) * (1 if hand == "right" else -1)
    z -= y * (y @ z)
    z /= np.linalg.norm(z)
    return np.column_stack([np.cross(y, z) * (1 if hand == "right" else -1), y, z]), np.linalg.norm(P[9] - P[0])


def samples_of(batch, dataset, files):
    samples = []  # file, landmark, per-view shares, (frame, palm, error)
    with tempfile.TemporaryDirectory() as folder:
        for k, file in enumerate(files):
            auto = json.load(open(file))
            cams = {c["name"]: c for c in auto["cameras"]}
            for f in auto["frames"]:
                out = os.path.join(folder, "j.json")
                subprocess.run([batch, "joints", dataset, "--sequence", auto["sequence"], "--frame", str(f["frame"]), "--out", out], check=True, capture_output=True)
                truth = {(j["hand"], j["name"]): np.array(j["xyz"]) for j in json.load(open(out))["joints"]}
                for hand, v in f["raters"][0]["hands"].items():
                    P = [np.array(v["joints"][n]["xyz"]) if n in v["joints"] else None for n in NAMES]
                    if any(p is None for p in P) or v["doubt"] > 0.6:
                        continue
                    sides = {c: side_of_square([project(cams[c], p) for p in P]) for c in cams}
                    for i, n in enumerate(NAMES):
                        if (hand, n) in truth:
                            shares = [(np.array(w["px"]) - project(cams[w["camera"]], truth[(hand, n)])) / sides[w["camera"]] for w in v["joints"][n]["views"]]
                            samples.append((k, i, shares, *frame_of(P, i, hand), P[i] - truth[(hand, n)]))
    return samples


def table(samples):
    rows = {}
    for i in range(21):
        mine = [s for s in samples if s[1] == i]
        if mine:
            bias = np.median([R.T @ e / palm for _, _, _, R, palm, e in mine], axis=0)
            left = [e - palm * R @ bias for _, _, _, R, palm, e in mine]
            rows[i] = (1.4826 * np.median(np.abs(np.concatenate([np.ravel(s[2]) for s in mine]))), bias, 1.4826 * np.median(np.abs(left)), mine)
    return rows


def main():
    fold = "--fold" in sys.argv
    batch, dataset, *files = [a for a in sys.argv[1:] if a != "--fold"]
    samples = samples_of(batch, dataset, files)
    for i, (spread, bias, floor, mine) in table(samples).items():
        print("    {%.4f, {%.3f, %.3f, %.3f}, %.1f}, // %s, %d hands" % (spread, *bias, floor, NAMES[i], len(mine)))
    if fold:
        learnt = table([s for s in samples if s[0] % 2 == 0])
        for what, use in (("as detected", False), ("without bias", True)):
            e = [np.linalg.norm(s[5] - (s[4] * s[3] @ learnt[s[1]][1] if use else 0)) for s in samples if s[0] % 2 == 1 and s[1] != 1]
            print("%s, other files: mean %.2f median %.2f 95%% %.2f mm" % (what, np.mean(e), np.median(e), np.percentile(e, 95)))


if __name__ == "__main__":
    main()
