package org.u2sa.drivers.ioio;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.device.FixReader;
import org.u2sa.device.HeadingReader;
import org.u2sa.device.TrueNorth;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.Sensor;

/** GPS and compass on the board's UARTs and their messages. Confined to the service's thread. */
final class PinSensors {
  private static final double SILENT_AFTER_S = 3.0;

  private final UartLink gpsLink = new UartLink();
  private final UartLink compassLink = new UartLink();
  private final Optional<FixReader> gps;
  private final Optional<HeadingReader> compass;

  /** Reads the device variables. */
  PinSensors(Sensor service, PinPlan plan) {
    SensorVariables variables = service.settings(SensorVariables.class).get();
    TrueNorth north = new TrueNorth(service);
    String name =
        service.sensorName(); // distinct sensor names, so that a new heading does not replace an
    // unread fix
    gps =
        plan.gps()
            .map(pins -> variables.gps(gpsLink, pins))
            .map(
                receiver ->
                    new FixReader(
                        service, receiver, name + " GPS", SILENT_AFTER_S, variables.gpsDelay()));
    compass =
        plan.compass()
            .map(pins -> variables.compass(compassLink, pins))
            .map(
                device ->
                    new HeadingReader(
                        service,
                        device,
                        name + " compass",
                        SILENT_AFTER_S,
                        north,
                        variables.compassMountingAngle(),
                        variables.headingSigma(),
                        variables.compassDelay()));
  }

  /** Sets the board's pins; empty while disconnected. */
  void attach(Optional<BoardPins> pins) {
    gpsLink.attach(pins.flatMap(BoardPins::gps));
    compassLink.attach(pins.flatMap(BoardPins::compass));
  }

  /**
   * Reads both devices. A lost board is reported once, not per device.
   *
   * @return messages to publish: each fix and heading once, with its own time
   */
  List<StateInformation> read(long nowMicros) {
    List<StateInformation> measured = new ArrayList<>(2);
    if (gpsLink.isConnected()) {
      gps.flatMap(reader -> reader.next(nowMicros)).ifPresent(measured::add);
    }
    for (StateInformation fix : measured) {
      compass.ifPresent(reader -> reader.at(fix, fix.timestamp().orElseThrow()));
    }
    if (compassLink.isConnected()) {
      compass.flatMap(reader -> reader.next(nowMicros)).ifPresent(measured::add);
    }
    return measured;
  }

  /** Sends pending data to the devices. */
  void send(long nowMicros, Optional<FlushCounter> lockstep) throws IOException {
    gpsLink.send(nowMicros, lockstep);
    compassLink.send(nowMicros, lockstep);
  }
}
