package org.u2sa.control.cascade;

import java.util.Arrays;
import java.util.OptionalDouble;
import org.u2sa.control.Pid;
import org.u2sa.control.Transfer;
import org.u2sa.control.allocation.Allocator;
import org.u2sa.control.allocation.DegreeOfFreedom;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.motion.DriftFilter;

/**
 * Computes the wrench that moves the vehicle to its target: proportional outer loops give
 * velocities and rates, inner PIDs give accelerations, scaled by mass. Not thread-safe.
 */
final class Cascade {
  private static final DegreeOfFreedom[] AXES = DegreeOfFreedom.values();
  private static final double VANE_PER_S = 0.1; // yaw rate per angle between bow and weather
  private static final double FLIES_FROM = 0.5; // minimum fraction of the weight lifted in flight
  private static final double COS_ON_SIDE = 0.49; // just over 60 deg, the upper limit of MAX LEAN
  private static final double MIN_AHEAD_MPS = 0.5; // which a vehicle at rest soon reaches
  private static final int SURGE = DegreeOfFreedom.SURGE.ordinal();
  private static final int SWAY = DegreeOfFreedom.SWAY.ordinal();
  private static final int HEAVE = DegreeOfFreedom.HEAVE.ordinal();

  private final CascadeVariables settings;
  private final AxisTuning[] tuning = new AxisTuning[DegreeOfFreedom.COUNT];
  private final Pid[] pids = new Pid[DegreeOfFreedom.COUNT];
  private final double[] wanted = new double[DegreeOfFreedom.COUNT]; // wanted velocities and rates
  private final double[] measured = new double[DegreeOfFreedom.COUNT];
  private final double[] attained = new double[DegreeOfFreedom.COUNT];
  private final double[] wrench = new double[DegreeOfFreedom.COUNT];
  private OptionalDouble headingRad = OptionalDouble.empty(); // heading to hold
  private double steerageMps; // minimum speed to steer; 0: it turns at rest
  private boolean turnsFirst; // turn first, without moving sideways
  private final Lean lean = new Lean(); // level unless the vehicle leans
  private final GroundWatch ground = new GroundWatch();
  private final SteadyPush push = new SteadyPush();
  private final DriftFilter drift = new DriftFilter();
  private Attitude attitude = new Attitude(0.0, 0.0, 0.0); // of the last step

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

  /** Computes the wanted wrench: X, Y, Z [N], K, M, N [N m]; valid until the next call. */
  double[] step(BodyMotion motion, MotionTarget target, double stepS) {
    if (!settings.leans()) {
      push.turn(pids[SURGE], pids[SWAY], motion.attitude().psi(), stepS);
    }
    drift.step(motion.attitude().psi(), motion.levelVelocity().y(), motion.rates().z(), stepS);
    weatherVane(target, stepS);
    aim(motion, target);
    boolean leans = settings.leans();
    if (leans) {
      double toGoDownM = target.way().orElse(Point.ORIGIN).z();
      boolean isOnSide =
          StrictMath.cos(attitude.phi()) * StrictMath.cos(attitude.theta()) < COS_ON_SIDE;
      ground.step(toGoDownM, wanted[HEAVE], measured[HEAVE], attained[HEAVE], isOnSide, stepS);
      if (ground.stands()) {
        rest();
        Arrays.fill(wrench, 0.0);
        return wrench;
      }
      double forward = pids[SURGE].step(wanted[SURGE], measured[SURGE], stepS);
      double right = pids[SWAY].step(wanted[SWAY], measured[SWAY], stepS);
      lean.towards(forward, right, Math.toRadians(settings.way().maxLean()));
      turn(motion);
    }
    for (int j = 0; j < AXES.length; j++) {
      boolean isDriven = tuning[j].isControlled() && !(leans && j <= SWAY);
      wrench[j] = isDriven ? pids[j].step(wanted[j], measured[j], stepS) : 0.0;
      if (leans && j == HEAVE) {
        wrench[j] = Lean.lift(wrench[j], attitude);
      }
      wrench[j] *= tuning[j].mass();
    }
    return wrench;
  }

  /**
   * Turns the bow into wind and current while the vehicle holds its position without a heading to
   * hold: towards the side to which its lateral force acts, until none is needed.
   */
  private void weatherVane(MotionTarget target, double stepS) {
    boolean stays = target.way().isPresent() && distanceM(target) < settings.way().facingDistance();
    if (!settings.way().weatherVanes() || !stays || target.headingRad().isPresent()) {
      return;
    }
    double turnRad = Math.atan2(pids[SWAY].integral(), Math.abs(pids[SURGE].integral()));
    double step = stepS * VANE_PER_S * turnRad;
    headingRad.ifPresent(heading -> headingRad = OptionalDouble.of(heading + step));
  }

  private static double distanceM(MotionTarget target) {
    return target.way().map(way -> Math.hypot(way.x(), way.y())).orElse(0.0);
  }

  private void aim(BodyMotion motion, MotionTarget target) {
    Point toGo = target.way().orElse(Point.ORIGIN);
    if (target.headingRad().isPresent()) {
      headingRad = target.headingRad();
    } else if ((settings.way().facesTheWay() || cannotSway())
        && distanceM(target) >= settings.way().facingDistance()) {
      double astern = target.isBackwards() ? Math.PI : 0.0;
      double course = Math.atan2(toGo.y(), toGo.x());
      double ahead = Math.max(MIN_AHEAD_MPS, motion.velocity().x());
      double crab =
          settings.way().countersDrift() && !target.isBackwards()
              ? drift.drift().crabRad(course, ahead)
              : 0.0;
      headingRad = OptionalDouble.of(course + astern + crab);
    } else if (headingRad.isEmpty()) {
      headingRad = OptionalDouble.of(motion.attitude().psi());
    }
    attitude = motion.attitude();
    Point velocity = velocity(motion, toGo, target);
    wanted[SURGE] = velocity.x();
    wanted[SWAY] = velocity.y();
    wanted[HEAVE] = velocity.z();
    Point present = settings.leans() ? motion.levelVelocity() : motion.velocity();
    measured[SURGE] = present.x();
    measured[SWAY] = present.y();
    measured[HEAVE] = present.z();
    turn(motion);
  }

  /** Computes the wanted rates, which turn the vehicle to its heading and lean angles. */
  private void turn(BodyMotion motion) {
    double heading = headingRad.orElse(attitude.psi()) - attitude.psi();
    Point euler =
        Point.of(
            towards(DegreeOfFreedom.ROLL, lean.rollRad() - attitude.phi()),
            towards(DegreeOfFreedom.PITCH, lean.pitchRad() - attitude.theta()),
            towards(DegreeOfFreedom.YAW, Math.IEEEremainder(heading, 2.0 * Math.PI)));
    Point rates = attitude.bodyRates(euler);
    wanted[3] = rates.x();
    wanted[4] = rates.y();
    wanted[5] = rates.z();
    measured[3] = motion.rates().x();
    measured[4] = motion.rates().y();
    measured[5] = motion.rates().z();
  }

  /**
   * Wanted velocity along the vehicle's axes [m/s]: forward, right and down of the levelled vehicle
   * within each axis's limit, and horizontally within the speed. Limited along the axes of a
   * pitched vehicle, it would not point to the target.
   */
  private Point velocity(BodyMotion motion, Point toGo, MotionTarget target) {
    Point level = motion.level(toGo);
    double forward = towards(DegreeOfFreedom.SURGE, level.x());
    double right = towards(DegreeOfFreedom.SWAY, level.y());
    if (turnsFirst || cannotSway()) {
      double aside = Math.hypot(level.x(), level.y());
      double ahead = aside > 0.0 ? level.x() / aside : 0.0;
      if (target.headingRad().isEmpty()) { // turn first
        double sign = target.isBackwards() ? -1.0 : 1.0;
        double needed = aside >= settings.way().facingDistance() ? steerageMps : 0.0;
        forward = sign * Math.max(needed, sign * towards(DegreeOfFreedom.SURGE, aside) * ahead);
      }
      right = 0.0;
    }
    double speedMps = target.speedMps().orElse(settings.way().cruiseSpeed());
    double speed = Math.hypot(forward, right);
    double scale = speed > speedMps ? speedMps / speed : 1.0;
    Point velocity =
        Point.of(scale * forward, scale * right, towards(DegreeOfFreedom.HEAVE, level.z()));
    return settings.leans() ? velocity : motion.fromLevel(velocity);
  }

  /** Sets the speed at which a vehicle that is steered by its flow turns [m/s]; 0: at rest too. */
  void steerage(double mps) {
    steerageMps = mps;
  }

  /** Whether it gets to a point abeam only by turning. */
  private boolean cannotSway() {
    return !settings.leans() && !tuning[SWAY].isControlled();
  }

  private double towards(DegreeOfFreedom axis, double error) {
    return tuning[axis.ordinal()].towards(error);
  }

  /** Updates the integrals with the attained part of the wrench (anti-windup). */
  void attained(Allocator allocator, double stepS) {
    for (int j = 0; j < AXES.length; j++) {
      if (settings.leans() && j <= SWAY) {
        attained[j] = j == SURGE ? lean.forward() : lean.right();
        pids[j].attained(attained[j], stepS);
      } else if (tuning[j].isControlled()) {
        attained[j] = acceleration(j, allocator.attained(AXES[j]));
        pids[j].attained(attained[j], stepS);
      }
    }
  }

  /** Acceleration due to a force or moment of the actuators, excluding gravity. */
  private double acceleration(int axis, double forceOrMoment) {
    double acceleration = forceOrMoment / tuning[axis].mass();
    return settings.leans() && axis == HEAVE ? Lean.down(acceleration, attitude) : acceleration;
  }

  /** Acceleration by the actuators along or about an axis [m/s², rad/s²]; 0 if not controlled. */
  double attained(DegreeOfFreedom axis) {
    return attained[axis.ordinal()];
  }

  /** Velocities [m/s] and rates [rad/s] of the last step, by axis. */
  double[] measured() {
    return measured;
  }

  /** Horizontal speed wanted in the last step [m/s]. */
  double wantedMps() {
    return Math.hypot(wanted[SURGE], wanted[SWAY]);
  }

  /** Resets one axis. */
  void rest(DegreeOfFreedom axis) {
    pids[axis.ordinal()].reset();
  }

  /**
   * Switches between control by sight in the vehicle's own axes and by states. Drops the heading to
   * hold, because it refers to axes that have turned. When controlled by sight, a vehicle that
   * faces its direction of travel must not move sideways, because that would look like turning.
   *
   * @param isMeasured whether the motion is measured, not derived from sightings
   */
  void goBySight(boolean bySight, boolean isMeasured) {
    turnsFirst = bySight && !isMeasured && settings.way().facesTheWay();
    if (bySight) {
      headingRad = OptionalDouble.empty();
    }
  }

  /** Resets integrals and heading, because the actuators do not obey. */
  void rest() {
    push.rest();
    for (Pid pid : pids) {
      pid.reset();
    }
    Arrays.fill(attained, 0.0);
    lean.towards(0.0, 0.0, 0.0);
    headingRad = OptionalDouble.empty();
  }

  /** Resets for a vehicle at rest because it is not armed. */
  void stand() {
    rest();
    ground.rest();
  }

  /** Whether an aircraft stands on the ground. */
  boolean stands() {
    return settings.leans() && ground.stands();
  }

  /**
   * Takes over from a wrench commanded by another law: bumplessly, but a motion away from the
   * target is braked at once.
   */
  void takeOver(BodyMotion motion, MotionTarget target, double[] present) {
    aim(motion, target);
    for (int j = 0; j < AXES.length; j++) {
      pids[j].takeOverMotion(acceleration(j, present[j]), wanted[j], measured[j]);
    }
    if (settings.leans()) {
      takeOverLean(present[HEAVE]);
    }
  }

  /** Continues from the current lean; the vehicle flies if it lifts most of its weight. */
  private void takeOverLean(double presentN) {
    double forward = -Gravity.STANDARD_MPS2 * StrictMath.tan(attitude.theta());
    double right =
        Gravity.STANDARD_MPS2
            * StrictMath.tan(attitude.phi())
            / Math.max(0.1, StrictMath.cos(attitude.theta()));
    pids[SURGE].takeOverMotion(forward, wanted[SURGE], measured[SURGE]);
    pids[SWAY].takeOverMotion(right, wanted[SWAY], measured[SWAY]);
    if (-presentN > FLIES_FROM * tuning[HEAVE].mass() * Gravity.STANDARD_MPS2) {
      ground.flies();
    }
  }

  void handOver(HandOver state) {
    if (settings.leans() && !ground.stands()) {
      state.text("FLIES", "true");
    }
    for (DegreeOfFreedom axis : AXES) {
      pids[axis.ordinal()].transfer(Transfer.saving(state), axis.name());
    }
    headingRad.ifPresent(heading -> state.number("HEADING", heading));
  }

  /**
   * @param isFresh whether integrals and heading are those of now
   */
  void takeOver(HandOver state, boolean isFresh) {
    state.text("FLIES").ifPresent(flies -> ground.flies());
    if (!isFresh) {
      return;
    }
    for (DegreeOfFreedom axis : AXES) {
      pids[axis.ordinal()].transfer(Transfer.restoring(state), axis.name());
    }
    headingRad = state.number("HEADING");
  }
}
