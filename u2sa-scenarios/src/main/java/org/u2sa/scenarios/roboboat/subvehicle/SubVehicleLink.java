package org.u2sa.scenarios.roboboat.subvehicle;

import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/**
 * Passes the Mission Manager's goal for the sub-vehicle to its system, at the object's mapped
 * position, and passes its report back (thesis 4.2.1.3). While the sub-vehicle is away, sends it
 * the carrier's displacement. In: goals, objects, state. Out: goal-reports.
 */
public final class SubVehicleLink extends PeriodicService {
  private static final double STEPS_PER_S = 5.0;
  private static final double MOVED_M = 0.05; // minimum displacement worth reporting

  private record Variables(
      @Variable(ifAbsentText = "localhost") @Description("Host of the sub-vehicle's broker.")
          String subVehicleHost,
      @Variable(min = 1, max = 65_535, ifAbsent = 1884)
          @Description("TCP port of the sub-vehicle's broker.")
          int subVehiclePort,
      @Variable(ifAbsentText = "puck-quadrotor") @Description("System ID of the sub-vehicle.")
          String subVehicleSystem,
      @Variable(ifAbsentText = "puck")
          @Description("Type of the object that the sub-vehicle fetches.")
          String fetchedType) {}

  private final Variables variables = settings(Variables.class).get();
  private final SubVehicle subVehicle;
  private final Queue<GoalInformation> reports = new ConcurrentLinkedQueue<>();
  private Optional<FetchGoal> task = Optional.empty(); // current
  private Optional<ObjectDescription> object = Optional.empty(); // as last seen
  private Optional<Geodetic> place = Optional.empty(); // position of the carrier
  private Optional<Geodetic> left = Optional.empty(); // its position when the goal was sent
  private Optional<FetchGoal> sent = Optional.empty();
  private Connection connection; // null until it is switched on

  public SubVehicleLink(ServiceContext context) {
    super(context, ServiceRole.OBSERVER, "SubVehicleLink", STEPS_PER_S);
    subVehicle =
        context
            .devices()
            .device(SubVehicle.class, getServiceName(), context.configuration(), context.clock())
            .orElse(
                () ->
                    new MqttTransport(
                        variables.subVehicleHost(),
                        variables.subVehiclePort(),
                        variables.subVehicleSystem(),
                        new MessageCodec(context.messageTypes())));
    registerPublisher(Channels.GOAL_REPORTS);
    subscribe(Channels.GOALS, this::onGoals);
    subscribe(Channels.OBJECTS, this::onObjects);
    subscribe(Channels.STATE, this::onState);
  }

  private void onGoals(GoalList list) {
    task =
        list.goals().stream()
            .filter(FetchGoal.class::isInstance)
            .map(FetchGoal.class::cast)
            .findFirst();
  }

  private void onObjects(ObjectList list) {
    object =
        list.objects().stream()
            .filter(each -> each.objectType().equals(variables.fetchedType()))
            .filter(each -> each.referenceFrame().isEarth())
            .findFirst()
            .or(() -> object);
  }

  private void onState(StateInformation state) {
    if (state.referenceFrame() == ReferenceFrame.GLOBAL
        && state.x().isPresent()
        && state.y().isPresent()) {
      place = Optional.of(new Geodetic(state.x().getAsDouble(), state.y().getAsDouble(), 0.0));
    }
  }

  @Override
  protected void step(double nowS) {
    if (task.isPresent() && !isSent(task.get())) {
      order(task.get().copy());
    } else if (task.isPresent()) {
      tellDeck();
    }
    for (GoalInformation each = reports.poll(); each != null; each = reports.poll()) {
      GoalInformation report = each.copy();
      report.systemId(context().systemId());
      log("goal \"" + report.uid() + "\": " + (report.completed() ? "done" : report.reason()));
      publish(Channels.GOAL_REPORTS, report);
      tell(List.of()); // the mission is over
      left = Optional.empty();
    }
  }

  private void order(FetchGoal goal) {
    if (connection == null) {
      Transport radio = subVehicle.switchOn();
      connection = radio.connect(getServiceName(), new Radio());
      connection.subscribe(Channels.GOAL_REPORTS);
    }
    if (object.isPresent()) {
      Point at = object.get().in(ReferenceFrame.GLOBAL, null).center();
      goal.x(at.x()).y(at.y());
    }
    tell(List.of(goal));
    sent = Optional.of(goal);
    left = place;
    log("goal \"" + goal.uid() + "\" sent to " + variables.subVehicleSystem());
  }

  private boolean isSent(FetchGoal goal) {
    return sent.filter(before -> before.uid().equals(goal.uid())).isPresent();
  }

  private void tellDeck() {
    if (left.isEmpty()) {
      return;
    }
    FetchGoal before = sent.orElseThrow();
    Point moved = left.get().enuOf(place.orElseThrow());
    if (Math.hypot(moved.x() - before.deckEast(), moved.y() - before.deckNorth()) > MOVED_M) {
      FetchGoal goal = before.copy().deckNorth(moved.y()).deckEast(moved.x());
      tell(List.of(goal));
      sent = Optional.of(goal);
    }
  }

  private void tell(List<GoalInformation> current) {
    GoalList goals = new GoalList().goals(current);
    goals.systemId(variables.subVehicleSystem());
    goals.timestamp(clock().micros());
    goals.freeze();
    connection.publish(Channels.GOALS, goals);
  }

  @Override
  protected void release() {
    if (connection != null) {
      connection.close();
    }
  }

  /** Messages from the sub-vehicle, received on its threads. */
  private final class Radio implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      if (message instanceof GoalInformation report) {
        reports.add(report);
      }
    }

    @Override
    public void trouble(String what) {
      log(LogLevelEnum.WARN, what);
    }
  }
}
