package org.u2sa.device;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;

/**
 * Where on the vehicle a sensor is, and how it is turned (thesis 4.1.2), in BODY: x forward, y
 * left, z down. The sensor's own axes are alike: x ahead of it, y to its left, z below.
 *
 * @param position of the sensor in BODY [m]
 * @param roll about the sensor's x axis, its left side down positive [rad], as BODY's phi
 * @param pitch its front up positive [rad], as BODY's theta
 * @param yaw turned to the left positive [rad], as BODY's psi
 */
public record MountingPose(Point position, double roll, double pitch, double yaw) {
  static final VariableDeclaration<Double> X =
      VariableDeclaration.number("MOUNTED X", "m")
          .range(Range.of(-100.0, 100.0))
          .ifAbsent(0.0)
          .describedAs("Place of the sensor on the vehicle, forward.");

  static final VariableDeclaration<Double> Y =
      VariableDeclaration.number("MOUNTED Y", "m")
          .range(Range.of(-100.0, 100.0))
          .ifAbsent(0.0)
          .describedAs("Place of the sensor on the vehicle, to the left.");

  static final VariableDeclaration<Double> Z =
      VariableDeclaration.number("MOUNTED Z", "m")
          .range(Range.of(-100.0, 100.0))
          .ifAbsent(0.0)
          .describedAs("Place of the sensor on the vehicle, down.");

  static final VariableDeclaration<Double> ROLL =
      VariableDeclaration.number("MOUNTED ROLL", "rad")
          .range(Range.of(-Math.PI, Math.PI))
          .ifAbsent(0.0)
          .describedAs("How the sensor is turned about its x axis, left side down positive.");

  static final VariableDeclaration<Double> PITCH =
      VariableDeclaration.number("MOUNTED PITCH", "rad")
          .range(Range.of(-Math.PI, Math.PI))
          .ifAbsent(0.0)
          .describedAs("How the sensor is tilted, front up positive.");

  static final VariableDeclaration<Double> YAW =
      VariableDeclaration.number("MOUNTED YAW", "rad")
          .range(Range.of(-Math.PI, Math.PI))
          .ifAbsent(0.0)
          .describedAs("How the sensor is turned about the vertical, to the left positive.");

  /** Declares and reads the variables. */
  public static MountingPose read(Configurator variables) {
    return new MountingPose(
        Point.of(variables.getVariable(X), variables.getVariable(Y), variables.getVariable(Z)),
        variables.getVariable(ROLL),
        variables.getVariable(PITCH),
        variables.getVariable(YAW));
  }

  /** What turns the sensor's vectors into the vehicle's; worth keeping for many points. */
  Turn turn() {
    // BODY is left-handed: rotations are done in FRD axes, where y, roll and yaw have the other
    // sign.
    Rotation frd = Rotation.nedFromFrd(-roll, pitch, -yaw);
    return seen -> mirrored(frd.times(mirrored(seen))).plus(position);
  }

  private static Point mirrored(Point point) {
    return Point.of(point.x(), -point.y(), point.z());
  }

  /** From the sensor's axes to BODY [m]. */
  @FunctionalInterface
  interface Turn {
    /** The same point in BODY. */
    Point toBody(Point seen);
  }
}
