package org.u2sa.device;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;

/**
 * Position and orientation of a sensor on the vehicle (thesis 4.1.2), in BODY: x forward, y left, z
 * down; the sensor's own axes likewise.
 */
public record MountingPose(
    @Variable(name = "MOUNTED X", unit = "m", min = -100, max = 100, ifAbsent = 0)
        @Description("Position of the sensor on the vehicle, forward.")
        double x,
    @Variable(name = "MOUNTED Y", unit = "m", min = -100, max = 100, ifAbsent = 0)
        @Description("Position of the sensor on the vehicle, to the left.")
        double y,
    @Variable(name = "MOUNTED Z", unit = "m", min = -100, max = 100, ifAbsent = 0)
        @Description("Position of the sensor on the vehicle, down.")
        double z,
    @Variable(name = "MOUNTED ROLL", unit = "rad", min = -Math.PI, max = Math.PI, ifAbsent = 0)
        @Description("Roll of the sensor about its x axis, left side down positive.")
        double roll,
    @Variable(name = "MOUNTED PITCH", unit = "rad", min = -Math.PI, max = Math.PI, ifAbsent = 0)
        @Description("Pitch of the sensor, front up positive.")
        double pitch,
    @Variable(name = "MOUNTED YAW", unit = "rad", min = -Math.PI, max = Math.PI, ifAbsent = 0)
        @Description("Yaw of the sensor, to the left positive.")
        double yaw) {
  /** Rotation from the sensor's axes to the vehicle's. */
  public Turn turn() {
    // BODY is left-handed: rotations are done in FRD axes, where y, roll and yaw have opposite
    // signs.
    Rotation frd = Rotation.nedFromFrd(-roll, pitch, -yaw);
    return seen -> mirrored(frd.times(mirrored(seen))).plus(Point.of(x, y, z));
  }

  /** Converts a point from BODY to the sensor's own axes: forward, left, down of it [m]. */
  public Point seen(Point body) {
    Rotation frd = Rotation.nedFromFrd(-roll, pitch, -yaw);
    return mirrored(frd.transposed().times(mirrored(body.minus(Point.of(x, y, z)))));
  }

  /** Sets a scan's mounting; returns the scan. */
  RangeScan placing(RangeScan scan) {
    return scan.x(x).y(y).z(z).phi(roll).theta(pitch).psi(yaw);
  }

  private static Point mirrored(Point point) {
    return Point.of(point.x(), -point.y(), point.z());
  }

  /** Converts from the sensor's axes to BODY [m]. */
  @FunctionalInterface
  public interface Turn {
    Point toBody(Point seen);
  }
}
