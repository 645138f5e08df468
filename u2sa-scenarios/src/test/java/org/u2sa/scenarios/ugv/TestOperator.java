package org.u2sa.scenarios.ugv;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceAction;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.OperatorHeartbeat;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Says on the channels what a scenario wants said, and hears what the Safety Manager says. Read it
 * between steps of the lockstep clock only.
 */
final class TestOperator extends PeriodicService {
  private static final double STEPS_PER_S = 100.0;
  private static final double HEARTBEAT_S = 1.0;

  private final Queue<Runnable> toSay = new ConcurrentLinkedQueue<>();
  private FailsafeState failsafe = new FailsafeState().action(FailsafeAction.CONTINUE);
  private ArmingState arming = new ArmingState().armed(false);
  private final Map<String, List<String>> remarks = new TreeMap<>();
  private final List<String> answers = new ArrayList<>();
  private Consumer<StateInformation> stateListener = state -> {};
  private int goalsDone;
  private boolean there;
  private double heartbeatDueS;

  TestOperator(ServiceContext context) {
    super(context, ServiceRole.OBSERVER, "TestOperator", STEPS_PER_S);
    registerSubscriber(Channels.FAILSAFE);
    registerSubscriber(Channels.ARMING_STATE);
    registerSubscriber(Channels.GOAL_REPORTS);
    registerSubscriber(Channels.HEALTH);
    registerSubscriber(Channels.STATE);
    registerSubscriber(Channels.SERVICE_ORDERS);
    registerSubscriber(Channels.CONFIGURATION);
    for (Channel<?> channel :
        List.of(
            Channels.OPERATOR,
            Channels.ARMING,
            Channels.EMERGENCY_STOP,
            Channels.SERVICE_ORDERS,
            Channels.CONFIGURATION)) {
      registerPublisher(channel);
    }
  }

  @Override
  protected void step(double nowS) {
    for (Runnable next = toSay.poll(); next != null; next = toSay.poll()) {
      next.run();
    }
    if (there && nowS >= heartbeatDueS) {
      heartbeatDueS = nowS + HEARTBEAT_S;
      publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann").interval(HEARTBEAT_S));
    }
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof FailsafeState state) {
      failsafe = state;
    } else if (data instanceof ArmingState state) {
      arming = state;
    } else if (data instanceof GoalInformation report && report.completed()) {
      goalsDone++;
    } else if (data instanceof HealthReport report) {
      remarks.put(report.serviceName(), report.remarks());
    } else if (data instanceof StateInformation newer) {
      stateListener.accept(newer);
    } else if (data instanceof ServiceOrderResult result) {
      answers.add(result.accepted() ? "done" : result.reason());
    } else if (data instanceof ConfigurationTransactionResult result) {
      answers.add(result.accepted() ? "done" : result.reason());
    }
  }

  /** Publishes a message at its next step, at most 10 ms from now. */
  <T extends U2SAData> void say(Channel<T> channel, T message) {
    toSay.add(() -> publish(channel, message));
  }

  /** Has another class take a service's place; see {@link #answers()}. */
  void swap(String service, Class<?> by) {
    say(
        Channels.SERVICE_ORDERS,
        new ServiceOrder()
            .requestId("swap for " + by.getSimpleName())
            .serviceName(service)
            .action(ServiceAction.SWAP)
            .className(by.getName())
            .operator("Ann"));
  }

  /** Changes a service's variable; see {@link #answers()}. */
  void set(String service, String variable, String value) {
    say(
        Channels.CONFIGURATION,
        new ConfigurationTransaction()
            .requestId(variable + " = " + value)
            .serviceName(service)
            .assignments(List.of(new ConfigurationAssignment().variableName(variable).value(value)))
            .author("Ann"));
  }

  /** Has somebody see each state, on the operator's thread. */
  void onState(Consumer<StateInformation> listener) {
    stateListener = listener;
  }

  /** What came of swaps and changes, in order: "done", or why not. */
  List<String> answers() {
    return answers;
  }

  /** Begins or ceases to send a heartbeat. */
  void isThere(boolean nowThere) {
    there = nowThere;
    heartbeatDueS = 0.0;
  }

  /** What a service remarked in its newest health report. */
  List<String> remarks(String service) {
    return remarks.getOrDefault(service, List.of());
  }

  FailsafeAction action() {
    return failsafe.action();
  }

  List<String> causes() {
    return failsafe.causes();
  }

  boolean armed() {
    return arming.armed();
  }

  int goalsDone() {
    return goalsDone;
  }
}
