package org.u2sa.scenarios.ugv;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.GoalInformation;
import org.u2sa.messages.GoalList;
import org.u2sa.messages.contract.ArmingState;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.scenarios.report.RunOutcome;
import org.u2sa.scenarios.report.RunPlan;
import org.u2sa.scenarios.report.TrackSample;
import org.u2sa.scenarios.run.RunObserver;
import org.u2sa.scenarios.run.RunRecord;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.U2SAService;
import org.u2sa.sim.ground.GroundState;

/**
 * Records where the simulated vehicle truly is, for score and screen, and whether it moves when it
 * must not. In: goals, goal-reports, arming-state. Out: nothing.
 */
final class UgvObserver extends PeriodicService implements RunObserver {
  private static final double LOOKS_PER_S = 20.0;
  private static final double STANDS_AFTER_S = 1.0; // without motion: not between two turns
  private static final double STOOD_S = 2.0; // at the end of the mission
  private static final double PARKED_WITHIN_S = 30.0; // after the last goal

  private final UgvWorld world;
  private final RunRecord record;
  private final UnarmedMotion unarmed = new UnarmedMotion();
  private double lastS = Double.NEGATIVE_INFINITY;
  private double movedS = Double.NEGATIVE_INFINITY;
  private double missionOverS = Double.POSITIVE_INFINITY;
  private volatile boolean over;

  /** See {@link RunObserver.Maker}. */
  UgvObserver(ServiceContext context, RunPlan plan, Consumer<TrackSample> screen, UgvWorld world) {
    super(context, ServiceRole.OBSERVER, "UgvObserver", LOOKS_PER_S);
    this.world = world;
    record = new RunRecord(plan, screen);
    registerSubscriber(Channels.GOALS);
    registerSubscriber(Channels.GOAL_REPORTS);
    registerSubscriber(Channels.ARMING_STATE);
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof GoalList goals) {
      if (record.isTargetUnseen()) { // waypoints nearer to each other than two looks
        look();
      }
      record.follow(goals);
    } else if (data instanceof GoalInformation report) {
      record.reported(report);
    } else if (data instanceof ArmingState state) {
      unarmed.see(state, world.truth());
    } else {
      unexpected(data);
    }
  }

  @Override
  protected void step(double nowS) {
    if (look()) {
      lookForTheEnd(lastS);
    }
  }

  /** Records the truth; false if its time stands still, as until the board is there. */
  private boolean look() {
    GroundState truth = world.truth();
    if (truth.timeS() <= lastS) {
      return false;
    }
    lastS = truth.timeS();
    unarmed.see(truth, world.motors(), world.rise(truth));
    if (UnarmedMotion.moves(truth)) {
      movedS = truth.timeS();
    }
    Geodetic place = world.place(truth);
    record.moment(
        Math.round(truth.timeS() * TimeUnit.SECONDS.toMicros(1)),
        place.longitudeDeg(),
        place.latitudeDeg(),
        place.altitudeM(),
        truth.headingRad(),
        truth.speedMps(),
        truth.timeS() - movedS < STANDS_AFTER_S ? "DRIVES" : "STANDS",
        Optional.empty());
    return true;
  }

  private void lookForTheEnd(double timeS) {
    if (record.isMissionOver()) {
      missionOverS = Math.min(missionOverS, timeS);
      boolean parked = timeS - Math.max(missionOverS, movedS) >= STOOD_S;
      over = parked || timeS - missionOverS >= PARKED_WITHIN_S;
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

  /** {@inheritDoc} The mission is over, and the vehicle stands. */
  @Override
  public boolean isOver() {
    return over;
  }

  /** {@inheritDoc} There is nothing on the lawn to hit. */
  @Override
  public RunOutcome outcome() {
    return new RunOutcome(0, false, List.copyOf(unarmed.violations()));
  }
}
