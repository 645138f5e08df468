package org.u2sa.gcs.mavlink;

import io.dronefleet.mavlink.common.MavSeverity;
import java.io.IOException;
import java.nio.channels.Selector;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.u2sa.gcs.mavlink.event.VehicleEvents;
import org.u2sa.gcs.mavlink.file.RecordingFolder;
import org.u2sa.gcs.mavlink.telemetry.FollowedRoute;
import org.u2sa.gcs.mavlink.vehicle.OrdersUnderWay;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.gcs.mavlink.vehicle.VehicleSurroundings;
import org.u2sa.gcs.remote.Operator;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.SerialLine;
import org.u2sa.interfaces.communication.SerialLineProvider;
import org.u2sa.mavlink.MavlinkSigning;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.schema.U2SAData;

/**
 * Presents a vehicle to MAVLink stations. One thread does all the work; only the vehicle's messages
 * arrive on the link's thread in a {@link VehicleStatus}.
 */
public final class MavlinkBridge implements AutoCloseable {
  private static final long TURN_MS = 10;
  private static final long[] ASK_AT_MICROS = {0, 1_000_000, 3_000_000, 8_000_000, 20_000_000};
  private static final long ASK_EVERY_MICROS = 60_000_000;

  private final RemoteLink link;
  private final BridgedVehicle vehicle;
  private final Selector selector;
  private final StationLink stations;
  private final Consumer<String> console;
  private final Thread thread;
  private final long beganMicros;
  private int asked;
  private FailsafeAction failsafe = FailsafeAction.CONTINUE;
  private volatile boolean isOpen = true;

  /**
   * Starts a bridge.
   *
   * @param link link to the vehicle; the bridge closes it
   * @param keys shared by the bridges of this process
   * @param console receives lines about the bridge
   * @throws BadInputException if the address is taken or the key cannot be read
   */
  public MavlinkBridge(
      RemoteLink link, BridgeOptions options, SigningKeys keys, Consumer<String> console) {
    this.link = link;
    this.console = console;
    vehicle =
        new BridgedVehicle(
            new OrdersUnderWay(link::publish, "mavlink:" + Operator.name()),
            options.identity(),
            options.kind(),
            link.systemId(),
            options.systemId(),
            options.logs().map(RecordingFolder::new),
            link.clock()::micros);
    Optional<MavlinkSigning> signing =
        options.key().map(file -> keys.of(link.systemId(), file, link.clock()::micros, console));
    try {
      selector = Selector.open();
      stations = stations(options.place(), () -> new StationSession(vehicle, signing));
    } catch (IOException e) {
      throw new BadInputException("MAVLink link " + options + ": " + e.getMessage(), e);
    }
    VehicleStatus.CHANNELS.forEach(
        channel -> link.listen(channel, message -> vehicle.model.take((U2SAData) message)));
    FollowedRoute.CHANNELS.forEach(
        channel -> link.listen(channel, message -> vehicle.route.take((U2SAData) message)));
    VehicleSurroundings.CHANNELS.forEach(
        channel -> link.listen(channel, message -> vehicle.surroundings.take((U2SAData) message)));
    VehicleEvents.CHANNELS.forEach(
        channel -> link.listen(channel, message -> vehicle.events.take((U2SAData) message)));
    beganMicros = link.clock().micros();
    thread = new Thread(this::run, "u2sa-mavlink");
    thread.setDaemon(true);
    thread.start();
  }

  private StationLink stations(StationPlace place, Supplier<StationSession> sessions)
      throws IOException {
    if (place instanceof StationPlace.Tcp tcp) {
      return new TcpLink(tcp.address(), sessions, selector);
    }
    if (place instanceof StationPlace.Udp udp) {
      return new UdpLink(udp.address(), sessions.get(), selector);
    }
    StationPlace.Serial serial = (StationPlace.Serial) place;
    SerialLine line =
        ServiceLoader.load(SerialLineProvider.class)
            .findFirst()
            .orElseThrow(() -> new IOException("serial ports need u2sa-drivers"))
            .open(serial.path(), serial.baud(), link.clock());
    return new SerialLink(line, serial.baud(), sessions.get());
  }

  private void run() {
    try {
      while (isOpen) {
        selector.select(TURN_MS);
        selector.selectedKeys().clear();
        turn(link.clock().micros());
      }
    } catch (IOException | RuntimeException e) { // the vehicle continues without it
      console.accept("the MAVLink bridge ended: " + e);
    }
  }

  private void turn(long nowMicros) throws IOException {
    try {
      ask(nowMicros);
      vehicle.model.refresh();
    } catch (CommunicationException e) {
      asked =
          Math.max(
              0, asked - 1); // the broker is unreachable; the link reports it and retries later
    }
    try {
      vehicle.orders.step(nowMicros);
    } catch (CommunicationException e) { // an answer led to another message
      console.accept("MAVLink bridge: " + e.getMessage());
    }
    List<Object> reached = vehicle.progress.reached();
    vehicle.events.step(reached);
    Optional<String> failsafe = failsafeText();
    for (StationSession session : stations.sessions()) {
      reached.forEach(session::send);
      failsafe.ifPresent(text -> session.text(MavSeverity.MAV_SEVERITY_CRITICAL, text));
      session.step(nowMicros);
    }
    stations.exchange(nowMicros);
  }

  private void ask(long nowMicros) {
    long sinceMicros = nowMicros - beganMicros;
    long due =
        asked < ASK_AT_MICROS.length
            ? ASK_AT_MICROS[asked]
            : ASK_EVERY_MICROS * (asked - ASK_AT_MICROS.length + 1);
    if (sinceMicros >= due) {
      asked++;
      vehicle.model.ask();
    }
  }

  private Optional<String> failsafeText() {
    FailsafeAction now = vehicle.model.failsafe();
    if (now == failsafe) {
      return Optional.empty();
    }
    failsafe = now;
    return Optional.of(
        "failsafe "
            + now
            + (vehicle.model.failsafeCauses().isEmpty()
                ? ""
                : ": " + String.join("; ", vehicle.model.failsafeCauses())));
  }

  /** Waits until the bridge ends. */
  public void await() throws InterruptedException {
    thread.join();
  }

  @Override
  public void close() {
    isOpen = false;
    selector.wakeup();
    try {
      thread.join();
      stations.close();
      selector.close();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (IOException e) {
      console.accept("the MAVLink bridge did not close its link: " + e);
    }
    link.close();
  }
}
