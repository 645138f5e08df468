package org.u2sa.flightgear.demo;

import java.util.List;
import java.util.function.Consumer;
import org.u2sa.flightgear.AircraftState;
import org.u2sa.flightgear.ControlStatus;
import org.u2sa.flightgear.control.FlightPhase;
import org.u2sa.flightgear.link.FlightChannels;
import org.u2sa.gcs.report.FlightPlan;
import org.u2sa.gcs.report.FlightSample;
import org.u2sa.gcs.report.FlightTrack;
import org.u2sa.interfaces.Clock;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.GoalInformation;
import org.u2sa.messages.GoalList;
import org.u2sa.messages.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Records the truth of a flight for its score and its screen. In: truth, goals, goal-reports,
 * control-status. Out: nothing.
 */
final class FlightObserver extends EventDrivenService {
  /** Past it the wing of the Cessna 172 no longer lifts more; clean, power off about 16°. */
  private static final double STALL_ANGLE_RAD = Math.toRadians(17.0);

  private static final double STANDS_MPS = 0.5;

  private final List<String> names;
  private final PlannedLegs legs;
  private final FlightTrack track = new FlightTrack();
  private final Consumer<FlightSample> screen;
  private String phase = "WAITING";
  private int leg = -1;
  private long startMicros = -1;
  private volatile boolean missionOver;
  private volatile boolean crashed;
  private volatile boolean landed;
  private boolean airborne;
  private volatile boolean stalled;
  private volatile int completed;
  private volatile long readings; // written by this service's thread only

  /**
   * @param screen is shown every sample, on this service's thread
   */
  FlightObserver(ServiceContext context, FlightPlan plan, Consumer<FlightSample> screen) {
    super(context, ServiceRole.OBSERVER, "FlightObserver");
    this.screen = screen;
    names = plan.waypoints().stream().map(waypoint -> waypoint.name()).toList();
    legs = new PlannedLegs(plan);
    registerSubscriber(FlightChannels.TRUTH);
    registerSubscriber(Channels.GOALS);
    registerSubscriber(Channels.GOAL_REPORTS);
    registerSubscriber(ControlStatus.CHANNEL);
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof AircraftState truth) {
      record(truth);
    } else if (data instanceof GoalList goals) {
      follow(goals);
    } else if (data instanceof ControlStatus status) {
      phase = status.phase().name();
    } else if (data instanceof GoalInformation report) {
      completed += report.completed() ? 1 : 0;
    } else {
      unexpected(data);
    }
  }

  private void follow(GoalList goals) {
    if (goals.goals().isEmpty()) {
      leg = names.size();
      missionOver = true;
    } else {
      leg = names.indexOf(goals.goals().get(0).uid());
    }
  }

  private void record(AircraftState truth) {
    long micros = truth.timestamp().orElseThrow();
    if (startMicros < 0) {
      startMicros = micros;
    }
    crashed |= truth.crashed();
    airborne |= !truth.weightOnWheels();
    stalled |= !truth.weightOnWheels() && angleOfAttackRad(truth) > STALL_ANGLE_RAD;
    double east = truth.xDot().orElseThrow();
    double north = truth.yDot().orElseThrow();
    double longitude = truth.x().orElseThrow();
    double latitude = truth.y().orElseThrow();
    landed |=
        airborne
            && phase.equals(FlightPhase.STOPPED.name())
            && Math.hypot(east, north) < STANDS_MPS;
    FlightSample sample =
        new FlightSample(
            Clock.seconds(micros - startMicros),
            longitude,
            latitude,
            truth.z().orElseThrow(),
            truth.psi().orElseThrow(),
            truth.phi().orElseThrow(),
            truth.theta().orElseThrow(),
            truth.calibratedAirspeed().orElseThrow(),
            Math.hypot(east, north),
            legs.crossTrackM(leg, longitude, latitude),
            leg,
            truth.weightOnWheels(),
            phase);
    track.append(sample);
    readings++;
    screen.accept(sample);
  }

  private static double angleOfAttackRad(AircraftState truth) {
    return Math.atan2(truth.fluidzDot().orElseThrow(), truth.fluidxDot().orElseThrow());
  }

  FlightTrack track() {
    return track;
  }

  /** Whether the Mission Manager has no goal left. */
  boolean isMissionOver() {
    return missionOver;
  }

  boolean isCrashed() {
    return crashed;
  }

  /** Whether it stands after a flight. */
  boolean isLanded() {
    return landed;
  }

  /** Whether the angle of attack went past the stall in the air. */
  boolean isStalled() {
    return stalled;
  }

  /** Readings of the aircraft so far. */
  long readings() {
    return readings;
  }

  /** Goals that were reported completed. */
  int completed() {
    return completed;
  }
}
