package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.Attitude;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.minimal.Heartbeat;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.Selector;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.OrdersUnderWay;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.mavlink.MavlinkStream;
import org.u2sa.messages.StateInformation;

/** Many vehicles whose bridges send to the port of one station, by a clock of the test. */
class FleetOnOnePortTest {
  private static final int VEHICLES = 25;
  private static final double SECONDS = 4.0;
  private static final long TURN_MICROS = 20_000;
  private static final double MIN_HZ = 4.0;

  private final AtomicLong clock = new AtomicLong(1_800_000_000_000_000L);
  private final MavlinkStream station = new MavlinkStream(255, 190, Optional.empty());
  private final ByteBuffer datagram = ByteBuffer.allocate(4096);
  private final Map<Integer, Map<Class<?>, Integer>> heard = new TreeMap<>(); // by MAVLink ID

  /** A vehicle whose session sends to the station. */
  private record Member(BridgedVehicle vehicle, StationSession session, UdpLink link) {}

  private Member member(int id, InetSocketAddress address, Selector selector) throws IOException {
    BridgedVehicle vehicle =
        new BridgedVehicle(
            new OrdersUnderWay((channel, message) -> {}, "tester"),
            Identity.PX4,
            Optional.of(VehicleKind.ROVER),
            "rover" + id,
            id,
            Optional.empty(),
            clock::get);
    StationSession session = new StationSession(vehicle, Optional.empty());
    return new Member(vehicle, session, new UdpLink(address, session, selector));
  }

  @Test
  void telemetry_of25Vehicles_reachesTheStationAtFourHertzEach() throws IOException {
    List<Member> fleet = new ArrayList<>();
    try (DatagramChannel port = DatagramChannel.open();
        Selector selector = Selector.open()) {
      port.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0))
          .configureBlocking(false);
      InetSocketAddress address = (InetSocketAddress) port.getLocalAddress();
      for (int id = 1; id <= VEHICLES; id++) {
        fleet.add(member(id, address, selector));
      }
      for (long t = 0; t < SECONDS * 1e6; t += TURN_MICROS) {
        clock.addAndGet(TURN_MICROS);
        for (Member member : fleet) {
          turn(member);
          listen(port);
        }
      }
      for (Member member : fleet) {
        member.link().close();
      }
    }
    assertThat(heard).hasSize(VEHICLES);
    heard.forEach(
        (id, counts) -> {
          assertThat(counts.get(GlobalPositionInt.class) / SECONDS)
              .as("positions of %s", id)
              .isGreaterThanOrEqualTo(MIN_HZ);
          assertThat(counts.get(Attitude.class) / SECONDS).isGreaterThanOrEqualTo(MIN_HZ);
          assertThat(counts.get(Heartbeat.class) / SECONDS).isGreaterThanOrEqualTo(0.9);
        });
  }

  private void turn(Member member) {
    double place = 1e-4 * member.vehicle().mavlinkId;
    StateInformation state =
        new StateInformation().x(10.0 + place).y(54.0).z(3.0).psi(1.0).xDot(1.0).yDot(0.5);
    state.freeze();
    member.vehicle().model.take(state);
    member.session().step(clock.get());
    member.link().exchange(clock.get());
  }

  private void listen(DatagramChannel port) throws IOException {
    for (datagram.clear(); port.receive(datagram) != null; datagram.clear()) {
      station.accept(
          datagram.array(),
          datagram.position(),
          message ->
              heard
                  .computeIfAbsent(message.systemId(), id -> new HashMap<>())
                  .merge(message.payload().getClass(), 1, Integer::sum));
    }
  }
}
