package org.u2sa.gcs.mavlink;

import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.Statustext;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Collectors;
import org.u2sa.gcs.mavlink.file.RecordingFolder;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.OrdersUnderWay;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.mavlink.MavlinkSigning;
import org.u2sa.mavlink.MavlinkStream;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.schema.U2SAData;

/** A bridge's session without a network: a station on one side, a scripted vehicle on the other. */
final class BridgeKit {
  static final int STATION = 255;
  static final double LONGITUDE = 10.0;
  static final double LATITUDE = 54.0;

  final AtomicLong clock = new AtomicLong(1_800_000_000_000_000L);
  final List<U2SAData> published = new ArrayList<>();
  boolean isLinkLost;
  final BridgedVehicle vehicle;
  final StationSession session;
  MavlinkStream station;
  private final List<Object> received = new ArrayList<>();

  BridgeKit(Identity identity, VehicleKind kind) {
    this(identity, kind, Optional.empty());
  }

  BridgeKit(Identity identity, VehicleKind kind, Optional<String> key) {
    this(identity, kind, key, Optional.empty());
  }

  BridgeKit(
      Identity identity,
      VehicleKind kind,
      Optional<String> key,
      Optional<RecordingFolder> recordings) {
    OrdersUnderWay orders = new OrdersUnderWay((channel, message) -> publish(message), "tester");
    vehicle =
        new BridgedVehicle(orders, identity, Optional.of(kind), "boat", 1, recordings, clock::get);
    session = new StationSession(vehicle, key.map(each -> new MavlinkSigning(each, clock::get)));
    station =
        new MavlinkStream(STATION, 190, key.map(each -> new MavlinkSigning(each, clock::get)));
    step();
  }

  private void publish(U2SAData message) {
    if (isLinkLost) {
      throw new CommunicationException("the connection is lost");
    }
    published.add(message);
  }

  /** Lets the station send as another of its components. */
  BridgeKit sendingAs(int component) {
    station = new MavlinkStream(STATION, component);
    return this;
  }

  static BridgeKit rover() {
    return new BridgeKit(Identity.PX4, VehicleKind.ROVER);
  }

  static Waypoint waypoint(String uid, double east, double north) {
    return new Waypoint().uid(uid).x(LONGITUDE + east).y(LATITUDE + north).horizontalThreshold(2.0);
  }

  /** The vehicle stands at its home and has two waypoints. */
  BridgeKit ready() {
    says(new StateInformation().x(LONGITUDE).y(LATITUDE).z(3.0).psi(1.0));
    says(new ArmingState().armed(false));
    mission("file.xml", List.of(waypoint("1", 0.001, 0.0), waypoint("2", 0.001, 0.001)), false);
    return this;
  }

  void mission(String origin, List<? extends GoalInformation> goals, boolean paused) {
    List<GoalInformation> all = new ArrayList<>(goals);
    all.add(waypoint("home", 0.0, 0.0));
    says(new GoalList().goals(goals.subList(0, 1)).paused(paused));
    says(
        new MissionReport()
            .requestId("r")
            .serviceName("MissionManager")
            .mission(origin)
            .goals(all)
            .finished(all.stream().map(goal -> 0.0).collect(Collectors.toList()))
            .current(List.of(goals.get(0).uid()))
            .sequence(goals.stream().map(GoalInformation::uid).collect(Collectors.toList()))
            .paused(paused));
  }

  void says(U2SAData message) {
    message.freeze();
    vehicle.model.take(message);
    vehicle.route.take(message);
    vehicle.events.take(message);
  }

  /** The station sends; what the bridge answers is in {@link #received}. */
  void send(Object message) {
    bytes(station.encode(message));
  }

  void bytes(byte[] bytes) {
    session.receive(bytes, bytes.length, clock.get());
    step();
  }

  void command(int id, double... parameters) {
    float[] p = new float[7];
    for (int i = 0; i < parameters.length; i++) {
      p[i] = (float) parameters[i];
    }
    send(
        CommandLong.builder()
            .targetSystem(1)
            .targetComponent(1)
            .command(EnumValue.create(MavCmd.class, id))
            .param1(p[0])
            .param2(p[1])
            .param3(p[2])
            .param4(p[3])
            .param5(p[4])
            .param6(p[5])
            .param7(p[6])
            .build());
  }

  void advance(double seconds) {
    for (double left = seconds; left > 0.0; left -= 0.1) {
      clock.addAndGet(100_000);
      step();
    }
  }

  void step() {
    try {
      vehicle.model.refresh();
    } catch (CommunicationException e) {
      received.add(e); // as the bridge does, which goes on
    }
    vehicle.orders.step(clock.get());
    vehicle.events.step(vehicle.progress.reached());
    session.step(clock.get());
    for (byte[] packet = session.poll(); packet != null; packet = session.poll()) {
      station.accept(packet, packet.length, message -> received.add(message.payload()));
    }
  }

  /** Messages of a class received since the last call; removes them. */
  <T> List<T> received(Class<T> type) {
    List<T> found =
        received.stream().filter(type::isInstance).map(type::cast).collect(Collectors.toList());
    received.removeAll(found);
    return found;
  }

  String texts() {
    return received(Statustext.class).stream().map(Statustext::text).collect(Collectors.joining());
  }

  /** Orders of a class published since the last call; removes them. */
  <T> List<T> orders(Class<T> type) {
    List<T> found =
        published.stream().filter(type::isInstance).map(type::cast).collect(Collectors.toList());
    published.removeAll(found);
    return found;
  }

  /** The mission order that waits for its answer. */
  MissionOrder order() {
    return published.stream()
        .filter(MissionOrder.class::isInstance)
        .map(MissionOrder.class::cast)
        .findFirst()
        .orElseThrow();
  }

  void answerMission(boolean accepted, String outcome) {
    MissionOrder order = orders(MissionOrder.class).get(0);
    says(
        new MissionOrderResult()
            .requestId(order.requestId())
            .serviceName("MissionManager")
            .accepted(accepted)
            .outcome(outcome));
    step();
  }

  /** Lets the orders under way run out. */
  void answerNothing() {
    advance(4.0);
  }

  void answerArming(boolean armed, String... reasons) {
    ArmCommand order = orders(ArmCommand.class).get(0);
    says(new ArmingState().armed(armed).reasons(List.of(reasons)).requestId(order.requestId()));
    step();
  }
}
