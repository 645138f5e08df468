package org.u2sa.service;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;

/** Writes down what it handles and hands the list over, so that the last of many knows all. */
class Counting extends EventDrivenService {
  static final Channel<GoalCommand> NUMBERS = Channels.GOAL_COMMANDS;

  List<String> handled = new ArrayList<>();
  private final List<String> order = new ArrayList<>(); // of what happens to it
  private final Consumer<HandOver> inTakeOver;
  private Consumer<HandOver> inHandOver = state -> {};

  Counting(ServiceContext context) {
    this(context, state -> {});
  }

  Counting(ServiceContext context, Consumer<HandOver> inTakeOver) {
    super(context, ServiceRole.OBSERVER, "Counting");
    this.inTakeOver = inTakeOver;
    registerSubscriber(NUMBERS);
    registerSubscriber(Channels.GOALS);
    registerPublisher(Channels.GOAL_REPORTS);
  }

  Counting inHandOver(Consumer<HandOver> action) {
    inHandOver = action;
    return this;
  }

  List<String> order() {
    return order;
  }

  @Override
  protected void handOver(HandOver state) {
    inHandOver.accept(state);
    state.texts("HANDLED", handled);
  }

  @Override
  protected void takeOver(HandOver state) {
    inTakeOver.accept(state);
    handled.addAll(state.texts("HANDLED"));
    order.add("takeOver");
  }

  @Override
  protected void begin() {
    order.add("begin");
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof GoalCommand command) {
      handled.add(command.uid());
    } else {
      order.add(data.type().name());
    }
  }

  @Override
  protected void release() {
    order.add("release");
    publish(Channels.GOAL_REPORTS, new Waypoint().horizontalThreshold(1.0).uid("released"));
  }
}
