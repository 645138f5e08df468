package org.u2sa.scenarios.suas;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.GroundPressure;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.messages.safety.OperatorHeartbeat;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * The demo's ground station with its operator: sends heartbeats and air pressure, and in flight the
 * search area; resumes the mission after a takeover. While it is down, it sends nothing and
 * receives no telemetry. In: mission, goals, manual-state. Out: operator, ground-pressure, mission.
 */
final class SuasStation extends PeriodicService {
  private static final String NAME = "SuasStation";
  private static final String RESUME = " resume";
  private static final double PRESSURE_S = 60.0;
  private static final double ANSWERED_S = 3.0; // after this the order is sent again

  /**
   * Behaviour of the station.
   *
   * @param toldPa air pressure at sea level that it sends [Pa]; 0 for none
   * @param area mission XML of the goals to insert once the first waypoint is current, if any
   * @param after goal after which to insert them
   * @param downFromS time at which it fails [s]
   * @param downUntilS time at which it works again [s]
   */
  record Script(
      double toldPa, Optional<String> area, String after, double downFromS, double downUntilS) {}

  private final Script script;
  private final Deque<String> toInsert = new ArrayDeque<>();
  private boolean flies;
  private boolean isByHand;
  private boolean resumes; // whether to resume the mission that a takeover has paused
  private double pressureDueS;
  private double orderDueS;
  private volatile int changes;
  private volatile boolean down;

  SuasStation(ServiceContext context, Script script) {
    super(context, ServiceRole.OBSERVER, NAME, 1.0);
    this.script = script;
    script.area().ifPresent(toInsert::add);
    registerPublisher(Channels.OPERATOR);
    registerPublisher(Channels.GROUND_PRESSURE);
    registerPublisher(Channels.MISSION);
    subscribe(Channels.GOALS, this::onGoals);
    subscribe(Channels.MISSION, this::onMission);
    subscribe(Channels.MANUAL_STATE, this::onManual);
  }

  private void onGoals(GoalList goals) {
    flies |= goals.goals().stream().anyMatch(goal -> goal.uid().equals("1"));
  }

  private void onManual(ManualState state) {
    resumes = !state.active() && state.takeovers() > 0;
    if (state.active() && !isByHand) {
      log("taken over by \"" + state.operator() + "\"");
    }
    isByHand = state.active();
  }

  private void onMission(U2SAData data) {
    if (data instanceof MissionOrderResult result && result.requestId().startsWith(NAME)) {
      log((result.accepted() ? "done: " : "refused: ") + result.outcome());
      boolean isResumed = result.requestId().endsWith(RESUME);
      if (isResumed) {
        resumes &= !result.accepted();
      } else if (result.accepted() && !toInsert.isEmpty()) {
        toInsert.remove();
        changes++;
      }
    }
  }

  @Override
  protected void step(double nowS) {
    down = nowS >= script.downFromS() && nowS < script.downUntilS();
    if (down) {
      return;
    }
    publish(Channels.OPERATOR, new OperatorHeartbeat().operator("ann").interval(1.0));
    if (script.toldPa() > 0.0 && nowS >= pressureDueS) {
      pressureDueS = nowS + PRESSURE_S;
      publish(
          Channels.GROUND_PRESSURE, new GroundPressure().operator("ann").pressure(script.toldPa()));
    }
    if (nowS >= orderDueS && (resumes || flies && !toInsert.isEmpty())) {
      orderDueS = nowS + ANSWERED_S;
      String id = NAME + " " + Math.round(nowS);
      MissionOrder order =
          resumes
              ? new MissionOrder().requestId(id + RESUME).action(MissionAction.RESUME)
              : new MissionOrder()
                  .requestId(id)
                  .action(MissionAction.INSERT)
                  .uid(script.after())
                  .goals(toInsert.peek());
      publish(Channels.MISSION, order.operator("ann"));
    }
  }

  /** Acknowledged in-flight changes of the mission. Thread-safe. */
  int changes() {
    return changes;
  }

  /** Whether it receives telemetry. Thread-safe. */
  boolean isUp() {
    return !down;
  }
}
