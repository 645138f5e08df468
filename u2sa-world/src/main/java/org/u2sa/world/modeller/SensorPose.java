package org.u2sa.world.modeller;

import java.util.Optional;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;

/**
 * Position and orientation of a scanner, in metres along the map's axes.
 *
 * @param place position of the scanner
 * @param vehicle position of the vehicle's reference point
 * @param ahead unit vector of a beam at angle 0
 * @param aside unit vector of a beam at angle π/2
 */
public record SensorPose(Point place, Point vehicle, Point ahead, Point aside) {
  /**
   * Pose of the sensor of a scan in the map.
   *
   * @param vehicle state of the vehicle at the time of the scan; empty in a map in BODY
   * @throws IllegalArgumentException if the scan is not in a body frame
   */
  public static SensorPose of(RangeScan scan, MapFrame map, Optional<StateInformation> vehicle) {
    ReferenceFrame frame = scan.referenceFrame();
    if (!frame.isBody()) {
      throw new IllegalArgumentException(
          "scan of \""
              + scan.sensorName()
              + "\" in "
              + frame
              + ": expected a frame of the vehicle");
    }
    // Signs of axes and angles relative to BODY_FRD, see ReferenceFrame.
    double y = frame.equals(ReferenceFrame.BODY_FRD) ? 1.0 : -1.0;
    double z = frame.equals(ReferenceFrame.BODY_FLU) ? -1.0 : 1.0;
    double roll = frame.equals(ReferenceFrame.BODY) ? -1.0 : 1.0;
    Rotation frdFromSensor =
        Rotation.nedFromFrd(roll * scan.phi(), z * scan.theta(), y * scan.psi());
    Rotation mapFromFrd = map.mapFromFrd(vehicle);
    Point origin = map.vehicle(vehicle);
    Point mounted = mapFromFrd.times(Point.of(scan.x(), y * scan.y(), z * scan.z()));
    Rotation all = mapFromFrd.times(frdFromSensor);
    Point ahead = all.times(Point.of(1.0, 0.0, 0.0));
    Point aside = all.times(Point.of(0.0, y, 0.0));
    if (map.frame().isBody()) { // BODY's y points left
      return new SensorPose(left(mounted), Point.ORIGIN, left(ahead), left(aside));
    }
    return new SensorPose(origin.plus(mounted), origin, ahead, aside);
  }

  private static Point left(Point frd) {
    return Point.of(frd.x(), -frd.y(), frd.z());
  }

  public Point at(double angle, double range) {
    double cos = range * Math.cos(angle);
    double sin = range * Math.sin(angle);
    return Point.of(
        place.x() + cos * ahead.x() + sin * aside.x(),
        place.y() + cos * ahead.y() + sin * aside.y(),
        place.z() + cos * ahead.z() + sin * aside.z());
  }
}
