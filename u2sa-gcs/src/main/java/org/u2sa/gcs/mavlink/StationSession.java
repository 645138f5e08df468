package org.u2sa.gcs.mavlink;

import io.dronefleet.mavlink.common.FileTransferProtocol;
import io.dronefleet.mavlink.common.MavSeverity;
import io.dronefleet.mavlink.common.Ping;
import io.dronefleet.mavlink.common.RequestDataStream;
import io.dronefleet.mavlink.common.Timesync;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.UUID;
import java.util.function.IntFunction;
import org.u2sa.gcs.mavlink.command.CommandService;
import org.u2sa.gcs.mavlink.command.MessageCommands;
import org.u2sa.gcs.mavlink.command.StickInput;
import org.u2sa.gcs.mavlink.command.VehicleCommands;
import org.u2sa.gcs.mavlink.event.EventTransfer;
import org.u2sa.gcs.mavlink.file.FileTransfer;
import org.u2sa.gcs.mavlink.file.LogDownload;
import org.u2sa.gcs.mavlink.parameter.ParameterService;
import org.u2sa.gcs.mavlink.plan.MissionService;
import org.u2sa.gcs.mavlink.station.GroundStation;
import org.u2sa.gcs.mavlink.station.StatusTexts;
import org.u2sa.gcs.mavlink.telemetry.MessageRates;
import org.u2sa.gcs.mavlink.vehicle.VehicleOrders;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.mavlink.MavlinkSigning;
import org.u2sa.mavlink.MavlinkStream;

/**
 * One station: passes its messages to the microservices, and queues packets for it. Confined to the
 * bridge's thread.
 */
final class StationSession implements GroundStation {
  private static final int QUEUE_BYTES = 256 * 1024;
  private static final int USUAL_ROOM_BYTES = 8 * 1024;
  private static final long NANOS = 1000;

  private final MavlinkStream stream;
  private final StationInput input;
  private final VehicleOrders orders;
  private final BridgedVehicle vehicle;
  private final MessageTargets targets;
  private final MessageRates rates;
  private final ParameterService parameters;
  private final MissionService mission;
  private final CommandService commands;
  private final FileTransfer transfer;
  private final LogDownload logs;
  private final StickInput sticks;
  private final EventTransfer events;
  private final StatusTexts texts = new StatusTexts();
  private final Deque<byte[]> queue = new ArrayDeque<>();
  private int queuedBytes;
  private int roomBytes = USUAL_ROOM_BYTES;
  private long steps;
  private boolean isHeard;

  StationSession(BridgedVehicle vehicle, Optional<MavlinkSigning> signing) {
    this.vehicle = vehicle;
    stream = new MavlinkStream(vehicle.mavlinkId, AUTOPILOT, signing.map(MavlinkSigning::link));
    input = new StationInput(stream, this::take);
    orders = new VehicleOrders(vehicle.orders);
    targets = new MessageTargets(vehicle.mavlinkId);
    rates = new MessageRates(vehicle.telemetry);
    boolean casts = vehicle.identity.castsParameters();
    parameters = new ParameterService(vehicle.model, orders, this, casts);
    mission = new MissionService(vehicle.model, orders, vehicle.book, vehicle.fences, this);
    transfer = new FileTransfer(vehicle.files, this);
    logs = new LogDownload(vehicle.files, this);
    events = new EventTransfer(vehicle.events, this);
    String connection = UUID.randomUUID().toString();
    IntFunction<String> drivers = station -> vehicle.orders.driver(connection, station);
    sticks =
        new StickInput(
            vehicle.model, orders, drivers, vehicle.mavlinkId, vehicle.uptime::unixMicros, this);
    commands =
        new CommandService(
            this,
            new MessageCommands(vehicle.telemetry, rates, vehicle.identity, vehicle.systemId, this),
            new VehicleCommands(
                vehicle.model, orders, vehicle.identity, vehicle.placement, vehicle.book, drivers),
            vehicle.identity);
  }

  /** Whether messages are handled at present, or what arrives is dropped but for a stop. */
  boolean isOpen(long micros) {
    return input.isOpen(micros);
  }

  /** Whether a valid packet has arrived (signed, if required). */
  boolean isHeard() {
    return isHeard;
  }

  /** Sets how long the rest of a packet may take to arrive [µs]. */
  void overdueAfter(long micros) {
    input.overdueAfter(micros);
  }

  /** Handles received bytes. */
  void receive(byte[] bytes, int length, long micros) {
    mission.step(micros);
    input.take(bytes, length, micros);
  }

  /** The station has left. */
  void close() {
    orders.close();
  }

  private boolean take(MavlinkStream.Received received) {
    boolean isForged = received.systemId() == vehicle.mavlinkId || received.systemId() == 0;
    if (isForged || !targets.include(received.payload())) {
      return false;
    }
    isHeard = true;
    Object message = received.payload();
    Sender from = new Sender(received.systemId(), received.componentId());
    try {
      boolean isHandled =
          parameters.handle(message)
              || mission.handle(message, from)
              || commands.handle(message, from)
              || sticks.handle(message, from)
              || events.handle(message, from);
      if (!isHandled) {
        takeOther(message, from);
      }
    } catch (CommunicationException e) {
      text(MavSeverity.MAV_SEVERITY_ERROR, e.getMessage());
    }
    return true;
  }

  @SuppressWarnings("deprecation") // stations still send these
  private void takeOther(Object message, Sender from) {
    if (message instanceof Timesync sync && sync.tc1() == 0) {
      send(
          Timesync.builder()
              .tc1(vehicle.uptime.micros() * NANOS)
              .ts1(sync.ts1())
              .targetSystem(from.system())
              .targetComponent(from.component())
              .build());
    } else if (message instanceof Ping ping && ping.targetSystem() == 0) {
      send(
          Ping.builder()
              .timeUsec(ping.timeUsec())
              .seq(ping.seq())
              .targetSystem(from.system())
              .targetComponent(from.component())
              .build());
    } else if (message instanceof FileTransferProtocol request) {
      transfer.handle(request, from);
    } else if (message instanceof RequestDataStream request) {
      rates.stream(request.reqStreamId(), request.reqMessageRate(), request.startStop() == 1);
    } else {
      logs.handle(message);
    }
  }

  /** Sets the number of queued bytes at which telemetry and bulk messages pause. */
  void room(int bytes) {
    roomBytes = bytes;
  }

  /** Sends due messages: telemetry and bulk messages take turns on a slow link. */
  void step(long micros) {
    input.step(micros);
    events.step();
    boolean isTelemetryFirst = steps++ % 2 == 0;
    if (isTelemetryFirst) {
      rates.step(micros, this);
    }
    parameters.step();
    transfer.step(micros);
    logs.step();
    if (!isTelemetryFirst) {
      rates.step(micros, this);
    }
    mission.step(micros);
  }

  @Override
  public void send(Object message) {
    byte[] packet = stream.encode(message);
    if (queuedBytes + packet.length <= QUEUE_BYTES) {
      queue.add(packet);
      queuedBytes += packet.length;
    }
  }

  @Override
  public void text(MavSeverity severity, String text) {
    texts.of(severity, text).forEach(this::send);
  }

  @Override
  public boolean hasRoom() {
    return queuedBytes < roomBytes;
  }

  /** Next packet to send; null if none is queued. */
  byte[] poll() {
    byte[] packet = queue.poll();
    queuedBytes -= packet == null ? 0 : packet.length;
    return packet;
  }
}
