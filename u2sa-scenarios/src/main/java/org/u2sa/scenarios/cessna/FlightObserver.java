package org.u2sa.scenarios.cessna;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.u2sa.control.fixedwing.ControlStatus;
import org.u2sa.control.fixedwing.FlightPhase;
import org.u2sa.flightgear.link.Simulator;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.TrackSample;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.U2SAService;
import org.u2sa.trials.run.RunObserver;
import org.u2sa.trials.run.RunRecord;

/**
 * Records the ground truth of a flight for scoring and display. In: truth, goals, goal-reports,
 * mission, control-status. Out: nothing.
 */
final class FlightObserver extends EventDrivenService implements RunObserver {
  /**
   * Angle of attack beyond which the Cessna 172's wing is stalled: about 16° clean and power off.
   */
  private static final double STALL_ANGLE_RAD = Math.toRadians(17.0);

  private static final double STANDS_MPS = 0.5;
  private static final double REPORTS_WITHIN_S = 5.0; // the planner a landing, once it stands

  private final RunRecord record;
  private String phase = "WAITING";
  private volatile boolean crashed;
  private long standsMicros = Long.MAX_VALUE; // since when it stands after its flight
  private volatile boolean landed;
  private boolean airborne;
  private volatile boolean stalled;

  /** See {@link RunObserver.Maker}. */
  FlightObserver(ServiceContext context, RunPlan plan, Consumer<TrackSample> screen) {
    super(context, ServiceRole.OBSERVER, "FlightObserver");
    record = new RunRecord(plan, plan.home().orElseThrow().place(), screen);
    registerSubscriber(Simulator.TRUTH);
    registerSubscriber(Channels.GOALS);
    registerSubscriber(Channels.GOAL_REPORTS);
    registerSubscriber(Channels.MISSION);
    registerSubscriber(ControlStatus.CHANNEL);
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof AircraftState truth) {
      see(truth);
    } else if (data instanceof ControlStatus status) {
      phase = status.phase().name();
    } else if (!record.received(data)) {
      unexpected(data);
    }
  }

  private void see(AircraftState truth) {
    crashed |= truth.crashed();
    airborne |= !truth.weightOnWheels();
    stalled |= !truth.weightOnWheels() && angleOfAttackRad(truth) > STALL_ANGLE_RAD;
    double speed = Math.hypot(truth.xDot().orElseThrow(), truth.yDot().orElseThrow());
    long now = truth.timestamp().orElseThrow();
    boolean stands = airborne && phase.equals(FlightPhase.STOPPED.name()) && speed < STANDS_MPS;
    standsMicros = stands ? Math.min(now, standsMicros) : Long.MAX_VALUE;
    landed |= stands && Clock.seconds(now - standsMicros) >= REPORTS_WITHIN_S;
    record.moment(
        now,
        truth.x().orElseThrow(),
        truth.y().orElseThrow(),
        truth.z().orElseThrow(),
        truth.psi().orElseThrow(),
        speed,
        phase,
        Optional.of(
            new TrackSample.Flight(
                truth.phi().orElseThrow(),
                truth.theta().orElseThrow(),
                truth.calibratedAirspeed().orElseThrow(),
                truth.weightOnWheels())));
  }

  private static double angleOfAttackRad(AircraftState truth) {
    return Math.atan2(truth.fluidzDot().orElseThrow(), truth.fluidxDot().orElseThrow());
  }

  @Override
  public U2SAService service() {
    return this;
  }

  @Override
  public RunRecord record() {
    return record;
  }

  /**
   * {@inheritDoc} True if the mission is over, or the aircraft crashed or has stopped after a
   * flight.
   */
  @Override
  public boolean isOver() {
    return record.isMissionOver() || crashed || landed;
  }

  /**
   * {@inheritDoc} Stalled if the angle of attack exceeded the stall angle in the air. A landing is
   * missed unless it was completed, although the aircraft passed its position.
   */
  @Override
  public RunOutcome outcome() {
    List<String> missed =
        record.landingsMissed().stream()
            .map(uid -> "landing \"" + uid + "\" was not completed")
            .toList();
    return new RunOutcome(crashed ? 1 : 0, stalled, missed).breaking(record.incomplete(Set.of()));
  }
}
