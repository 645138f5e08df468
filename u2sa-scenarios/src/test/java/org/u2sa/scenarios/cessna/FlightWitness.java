package org.u2sa.scenarios.cessna;

import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.u2sa.control.fixedwing.ControlStatus;
import org.u2sa.flightgear.link.Simulator;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.OperatorHeartbeat;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Sees a flight as the simulator knows it, not as the estimator does, and says on the channels what
 * a scenario wants said. Read it between steps of the lockstep clock only.
 */
final class FlightWitness extends PeriodicService {
  private static final double STEPS_PER_S = 10.0;
  private static final double HEARTBEAT_S = 1.0;

  /** The aircraft at one time; east and north of home [m]. */
  record Moment(
      double timeS,
      double eastM,
      double northM,
      double altitudeM,
      double heightM,
      double climbMps,
      double speedMps,
      double rollRad,
      double airspeedMps,
      double rpm,
      boolean onGround,
      boolean crashed) {}

  private final Geodetic home;
  private final List<Moment> moments = new ArrayList<>();
  private final List<String> reached = new ArrayList<>();
  private final List<String> told = new ArrayList<>();
  private final Queue<Runnable> toSay = new ConcurrentLinkedQueue<>();
  private FailsafeState failsafe = new FailsafeState().action(FailsafeAction.CONTINUE);
  private ArmingState arming = new ArmingState().armed(false);
  private EmergencyStop stop;
  private String phase = "";
  private boolean operatorThere;
  private double heartbeatDueS;

  FlightWitness(ServiceContext context, Geodetic home) {
    super(context, ServiceRole.OBSERVER, "FlightWitness", STEPS_PER_S);
    this.home = home;
    registerSubscriber(Simulator.TRUTH);
    registerSubscriber(ControlStatus.CHANNEL);
    registerSubscriber(Channels.GOAL_REPORTS);
    registerSubscriber(Channels.FAILSAFE);
    registerSubscriber(Channels.ARMING_STATE);
    registerSubscriber(Channels.EMERGENCY_STOP);
    for (Channel<?> channel :
        List.of(
            Channels.OPERATOR,
            Channels.POWER,
            Channels.CONDITIONS,
            Channels.ARMING,
            Channels.SERVICE_ORDERS,
            Channels.EMERGENCY_STOP)) {
      registerPublisher(channel);
    }
  }

  @Override
  protected void step(double nowS) {
    for (Runnable next = toSay.poll(); next != null; next = toSay.poll()) {
      next.run();
    }
    if (operatorThere && nowS >= heartbeatDueS) {
      heartbeatDueS = nowS + HEARTBEAT_S;
      publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann").interval(HEARTBEAT_S));
    }
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof AircraftState truth) {
      moments.add(moment(truth));
    } else if (data instanceof ControlStatus status) {
      phase = status.phase().name();
    } else if (data instanceof GoalInformation report && report.completed()) {
      reached.add(report.uid());
    } else if (data instanceof FailsafeState state) {
      if (state.action() != failsafe.action()) {
        told.add(state.action() + " " + state.causes());
      }
      failsafe = state;
    } else if (data instanceof ArmingState state) {
      arming = state;
    } else if (data instanceof EmergencyStop heard) {
      stop = heard;
    }
  }

  private Moment moment(AircraftState truth) {
    Point place =
        home.enuOf(
            new Geodetic(
                truth.x().orElseThrow(), truth.y().orElseThrow(), truth.z().orElseThrow()));
    return new Moment(
        Clock.seconds(truth.timestamp().orElseThrow()),
        place.x(),
        place.y(),
        truth.z().orElseThrow(),
        truth.heightAboveGround().orElseThrow(),
        truth.zDot().orElseThrow(),
        Math.hypot(truth.xDot().orElseThrow(), truth.yDot().orElseThrow()),
        truth.phi().orElseThrow(),
        truth.calibratedAirspeed().orElseThrow(),
        truth.engineRpm().orElseThrow(),
        truth.weightOnWheels(),
        truth.crashed());
  }

  /** Publishes a message at its next step. */
  <T extends U2SAData> void say(Channel<T> channel, T message) {
    toSay.add(() -> publish(channel, message));
  }

  /** Begins or ceases to send an operator's heartbeat. */
  void operatorIsThere(boolean there) {
    operatorThere = there;
    heartbeatDueS = 0.0;
  }

  List<Moment> moments() {
    return moments;
  }

  Moment last() {
    return moments.get(moments.size() - 1);
  }

  FailsafeAction action() {
    return failsafe.action();
  }

  List<String> causes() {
    return failsafe.causes();
  }

  /** Each change of the failsafe's action, with its causes. */
  List<String> told() {
    return told;
  }

  ArmingState arming() {
    return arming;
  }

  /** The newest emergency stop or clear; null if there was none. */
  EmergencyStop emergencyStop() {
    return stop;
  }

  /** Goals that were reported completed, in their order. */
  List<String> reached() {
    return reached;
  }

  String phase() {
    return phase;
  }
}
