package org.u2sa.trials.run;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.TrackSample;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.U2SAService;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

/**
 * Records the ground truth of a simulated vehicle for scoring and display. In: goals, goal-reports,
 * mission, arming-state. Out: nothing.
 */
public final class TruthObserver extends PeriodicService implements RunObserver {
  private static final double LOOKS_PER_S = 20.0;
  private static final double SLOWEST_MPS = 0.02;
  private static final double SLOWEST_RADPS = 0.05;
  private static final double STANDS_AFTER_S = 1.0; // standstill; longer than between turns
  private static final double STOOD_S = 2.0; // standstill at the end of the mission
  private static final double PARKED_WITHIN_S = 30.0; // time limit after the last goal

  private final RunningVehicle vehicle;
  private final Clock clock;
  private final LocalPlane plane;
  private final Scorer scorer;
  private final RunRecord record;
  private double lastS = Double.NEGATIVE_INFINITY;
  private double movedS = Double.NEGATIVE_INFINITY;
  private double missionOverS = Double.POSITIVE_INFINITY;
  private volatile boolean over;

  private TruthObserver(
      ServiceContext context,
      RunRecord record,
      RunningVehicle vehicle,
      LocalPlane plane,
      Scorer scorer) {
    super(context, ServiceRole.OBSERVER, "TruthObserver", LOOKS_PER_S);
    this.record = record;
    this.vehicle = vehicle;
    clock = context.clock();
    this.plane = plane;
    this.scorer = scorer;
    registerSubscriber(Channels.GOALS);
    registerSubscriber(Channels.GOAL_REPORTS);
    registerSubscriber(Channels.MISSION);
    registerSubscriber(Channels.ARMING_STATE);
    scorer.listensTo().forEach(this::registerSubscriber);
  }

  /**
   * Creates an observer of a vehicle.
   *
   * @param scorer creates the scorer on the run's clock
   */
  static RunObserver.Maker of(
      RunningVehicle vehicle, LocalPlane plane, Function<Clock, Scorer> scorer) {
    return (ServiceContext context, RunPlan plan, Consumer<TrackSample> screen) ->
        new TruthObserver(
            context,
            new RunRecord(plan, plane.origin(), screen),
            vehicle,
            plane,
            scorer.apply(context.clock()));
  }

  /** Whether a vehicle is moving. */
  public static boolean moves(VehicleTruth truth) {
    return truth.speedMps() > SLOWEST_MPS || Math.abs(truth.rates().z()) > SLOWEST_RADPS;
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof GoalList && record.isTargetUnseen()) {
      look(); // for waypoints closer together than two samples
    }
    if (data instanceof GoalInformation report) {
      scorer.reported(report);
    }
    if (data instanceof ArmingState state) {
      scorer.armed(state, vehicle.at(clock.micros()));
    } else if (!record.received(data) && !scorer.heard(data)) {
      unexpected(data);
    }
  }

  @Override
  protected void step(double nowS) {
    if (look()) {
      lookForTheEnd(lastS);
    }
  }

  /**
   * Records the ground truth; false if its time has not advanced, e.g. before the vehicle exists.
   */
  private boolean look() {
    VehicleTruth truth = vehicle.at(clock.micros());
    if (truth.timeS() <= lastS) {
      return false;
    }
    lastS = truth.timeS();
    scorer.see(truth);
    if (moves(truth)) {
      movedS = truth.timeS();
    }
    Point at = truth.position();
    Geodetic place = plane.at(at.x(), at.y(), at.z());
    record.moment(
        Math.round(truth.timeS() * TimeUnit.SECONDS.toMicros(1)),
        place.longitudeDeg(),
        place.latitudeDeg(),
        place.altitudeM(),
        truth.headingRad(),
        truth.speedMps(),
        scorer.phase(truth.timeS() - movedS < STANDS_AFTER_S),
        Optional.empty());
    return true;
  }

  private void lookForTheEnd(double timeS) {
    if (record.isMissionOver()) {
      missionOverS = Math.min(missionOverS, timeS);
      boolean parked = timeS - Math.max(missionOverS, movedS) >= STOOD_S;
      boolean lasts = timeS - missionOverS >= PARKED_WITHIN_S && !scorer.isWaiting();
      over = parked || lasts;
    } else {
      missionOverS = Double.POSITIVE_INFINITY; // also if an operator has resumed it
    }
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
   * {@inheritDoc} True if the mission is over and the vehicle has stopped, or if the scorer ends
   * the run.
   */
  @Override
  public boolean isOver() {
    return over || scorer.isOver();
  }

  @Override
  public RunOutcome outcome() {
    return scorer.outcome().breaking(record.incomplete(scorer.required()));
  }

  /**
   * Scores a run by the ground truth, in addition to its waypoints. Confined to the observer's
   * thread.
   */
  public interface Scorer {
    /** Processes a sample later than the previous one. */
    default void see(VehicleTruth truth) {}

    /** Processes an arming state with the ground truth at that time. */
    default void armed(ArmingState state, VehicleTruth truth) {}

    /** Processes a report on a goal. */
    default void reported(GoalInformation report) {}

    /** Goals of the mission at the start that the rules require to be completed. */
    default Set<String> required() {
      return Set.of();
    }

    /** Additional channels besides goals, goal reports and arming state. */
    default List<Channel<?>> listensTo() {
      return List.of();
    }

    /** Processes a message of those channels; false if the type is unknown. */
    default boolean heard(U2SAData data) {
      return false;
    }

    /** Whether the rules end the run now. Thread-safe. */
    default boolean isOver() {
      return false;
    }

    /** Whether the run continues although the vehicle still moves long after its last goal. */
    default boolean isWaiting() {
      return false;
    }

    /** The vehicle's activity in one word. */
    default String phase(boolean moves) {
      return moves ? "MOVES" : "STANDS";
    }

    /** The outcome, once the run has ended. */
    default RunOutcome outcome() {
      return new RunOutcome(0, false, List.of());
    }
  }
}
