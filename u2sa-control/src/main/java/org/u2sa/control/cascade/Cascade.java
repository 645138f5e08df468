package org.u2sa.control.cascade;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.control.Pid;
import org.u2sa.control.allocation.Allocator;
import org.u2sa.control.allocation.DegreeOfFreedom;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.handover.HandOver;

/**
 * Computes the wrench that moves the vehicle to its target: proportional outer loops give
 * velocities and rates, inner PIDs give accelerations, scaled by mass. Not thread-safe.
 */
final class Cascade {
  private static final DegreeOfFreedom[] AXES = DegreeOfFreedom.values();
  private static final double LEVEL = 0.0; // roll and pitch [rad]

  private final CascadeVariables settings;
  private final AxisTuning[] tuning = new AxisTuning[DegreeOfFreedom.COUNT];
  private final Pid[] pids = new Pid[DegreeOfFreedom.COUNT];
  private final double[] wanted = new double[DegreeOfFreedom.COUNT]; // wanted velocities and rates
  private final double[] measured = new double[DegreeOfFreedom.COUNT];
  private final double[] attained = new double[DegreeOfFreedom.COUNT];
  private final double[] wrench = new double[DegreeOfFreedom.COUNT];
  private OptionalDouble headingRad = OptionalDouble.empty(); // heading to hold
  private boolean turnsFirst; // turns first, without moving sideways

  Cascade(CascadeVariables settings) {
    this.settings = settings;
    for (DegreeOfFreedom axis : AXES) {
      tuning[axis.ordinal()] = settings.of(axis);
      pids[axis.ordinal()] = new Pid(tuning[axis.ordinal()].gains());
    }
  }

  /** Applies changed gains. */
  void retune() {
    for (DegreeOfFreedom axis : AXES) {
      tuning[axis.ordinal()] = settings.of(axis);
      pids[axis.ordinal()].gains(tuning[axis.ordinal()].gains());
    }
  }

  /**
   * Computes the wanted wrench: X, Y, Z [N], K, M, N [N m]; valid until the next call.
   *
   * @param way vector to the target: north, east, down [m]; empty to stop and hold the heading
   */
  double[] step(BodyMotion motion, Optional<Point> way, Optional<Double> speedMps, double stepS) {
    aim(motion, way, speedMps);
    for (int j = 0; j < AXES.length; j++) {
      wrench[j] =
          tuning[j].isControlled()
              ? tuning[j].mass() * pids[j].step(wanted[j], measured[j], stepS)
              : 0.0;
    }
    return wrench;
  }

  private void aim(BodyMotion motion, Optional<Point> way, Optional<Double> speedMps) {
    Point toGo = way.orElse(Point.ORIGIN);
    double distance = Math.hypot(toGo.x(), toGo.y());
    double heading = motion.attitude().psi();
    if (settings.facesTheWay() && distance >= settings.facingDistanceM()) {
      headingRad = OptionalDouble.of(Math.atan2(toGo.y(), toGo.x()));
    } else if (headingRad.isEmpty()) {
      headingRad = OptionalDouble.of(heading);
    }
    double turn = Math.IEEEremainder(headingRad.getAsDouble() - heading, 2.0 * Math.PI);
    Point velocity = velocity(motion, toGo, speedMps.orElse(settings.cruiseMps()));
    wanted[0] = velocity.x();
    wanted[1] = velocity.y();
    wanted[2] = velocity.z();
    Point euler =
        Point.of(
            towards(DegreeOfFreedom.ROLL, LEVEL - motion.attitude().phi()),
            towards(DegreeOfFreedom.PITCH, LEVEL - motion.attitude().theta()),
            towards(DegreeOfFreedom.YAW, turn));
    Point rates = motion.attitude().bodyRates(euler);
    wanted[3] = rates.x();
    wanted[4] = rates.y();
    wanted[5] = rates.z();
    measured[0] = motion.velocity().x();
    measured[1] = motion.velocity().y();
    measured[2] = motion.velocity().z();
    measured[3] = motion.rates().x();
    measured[4] = motion.rates().y();
    measured[5] = motion.rates().z();
  }

  /**
   * Wanted velocity along the vehicle's axes [m/s], with each axis within its limit and the total
   * within the speed.
   */
  private Point velocity(BodyMotion motion, Point toGo, double speedMps) {
    Point body = motion.frd(toGo);
    double forward = towards(DegreeOfFreedom.SURGE, body.x());
    double right = towards(DegreeOfFreedom.SWAY, body.y());
    if (turnsFirst || !tuning[DegreeOfFreedom.SWAY.ordinal()].isControlled()) {
      double aside = Math.hypot(body.x(), body.y());
      double ahead = aside > 0.0 ? body.x() / aside : 0.0;
      forward = Math.max(0.0, towards(DegreeOfFreedom.SURGE, aside) * ahead); // turn first
      right = 0.0;
    }
    double speed = Math.hypot(forward, right);
    double scale = speed > speedMps ? speedMps / speed : 1.0;
    return Point.of(scale * forward, scale * right, towards(DegreeOfFreedom.HEAVE, body.z()));
  }

  private double towards(DegreeOfFreedom axis, double error) {
    return tuning[axis.ordinal()].towards(error);
  }

  /** Updates the integrals with the attained part of the wrench (anti-windup). */
  void attained(Allocator allocator, double stepS) {
    for (int j = 0; j < AXES.length; j++) {
      if (tuning[j].isControlled()) {
        attained[j] = allocator.attained(AXES[j]) / tuning[j].mass();
        pids[j].attained(attained[j], stepS);
      }
    }
  }

  /** Acceleration by the actuators along or about an axis [m/s², rad/s²]; 0 if not controlled. */
  double attained(DegreeOfFreedom axis) {
    return attained[axis.ordinal()];
  }

  /** Velocities [m/s] and rates [rad/s] of the last step, by axis. */
  double[] measured() {
    return measured;
  }

  /** Resets one axis. */
  void rest(DegreeOfFreedom axis) {
    pids[axis.ordinal()].reset();
  }

  /**
   * Switches between control by sight in the vehicle's own axes and by states. The heading to hold
   * is dropped, because it refers to axes that have turned; by sight, a vehicle that faces its
   * direction of travel must not move sideways, which would look like turning.
   */
  void goBySight(boolean bySight) {
    turnsFirst = bySight && settings.facesTheWay();
    if (bySight) {
      headingRad = OptionalDouble.empty();
    }
  }

  /** Resets integrals and heading, because the actuators do not obey. */
  void rest() {
    for (Pid pid : pids) {
      pid.reset();
    }
    Arrays.fill(attained, 0.0);
    headingRad = OptionalDouble.empty();
  }

  /** Takes over from a wrench commanded by another law (bumpless transfer). */
  void takeOver(
      BodyMotion motion, Optional<Point> way, Optional<Double> speedMps, double[] present) {
    aim(motion, way, speedMps);
    for (int j = 0; j < AXES.length; j++) {
      pids[j].takeOver(present[j] / tuning[j].mass(), wanted[j], measured[j]);
    }
  }

  void handOver(HandOver state) {
    for (DegreeOfFreedom axis : AXES) {
      pids[axis.ordinal()].handOver(state, axis.name());
    }
    headingRad.ifPresent(heading -> state.number("HEADING", heading));
  }

  void takeOver(HandOver state) {
    for (DegreeOfFreedom axis : AXES) {
      pids[axis.ordinal()].takeOver(state, axis.name());
    }
    headingRad = state.number("HEADING");
  }
}
