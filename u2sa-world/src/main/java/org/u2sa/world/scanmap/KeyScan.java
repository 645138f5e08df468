package org.u2sa.world.scanmap;

import org.u2sa.messages.RangeScan;

/** A scan kept in the map; loop closures adjust its pose. */
final class KeyScan {
  private final ScanPoints points;
  private final RangeScan scan;
  private final double drivenM;
  private Pose2 pose;

  /**
   * @param points echoes in the vehicle's axes
   * @param scan the scan itself, from which to rebuild the grid
   * @param drivenM distance driven so far [m]
   */
  KeyScan(Pose2 pose, ScanPoints points, RangeScan scan, double drivenM) {
    this.pose = pose;
    this.points = points;
    this.scan = scan;
    this.drivenM = drivenM;
  }

  Pose2 pose() {
    return pose;
  }

  void moveTo(Pose2 newPose) {
    pose = newPose;
  }

  ScanPoints points() {
    return points;
  }

  RangeScan scan() {
    return scan;
  }

  double drivenM() {
    return drivenM;
  }
}
