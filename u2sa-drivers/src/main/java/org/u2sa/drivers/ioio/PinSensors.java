package org.u2sa.drivers.ioio;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.u2sa.device.DeviceReader;
import org.u2sa.device.mapping.FixMapping;
import org.u2sa.device.mapping.HeadingMapping;
import org.u2sa.device.mapping.TrueNorth;
import org.u2sa.device.port.Device;
import org.u2sa.device.port.GpsFix;
import org.u2sa.device.port.Heading;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.Sensor;

/** GPS and compass on the board's UARTs and their messages. Confined to the service's thread. */
final class PinSensors {
  private static final double SILENT_AFTER_S = 3.0;
  private static final String GPS = "the GPS receiver";
  private static final String COMPASS = "the compass";

  private final UartLink gpsLink = new UartLink(GPS);
  private final UartLink compassLink = new UartLink(COMPASS);
  private final TrueNorth north;
  private final FixMapping fixes;
  private final HeadingMapping headings;
  private final Optional<DeviceReader<GpsFix>> gps;
  private final Optional<DeviceReader<Heading>> compass;

  /** Reads the device variables. */
  PinSensors(Sensor service, PinPlan plan) {
    SensorVariables variables = service.settings(SensorVariables.class).get();
    north = new TrueNorth(service);
    String name =
        service.sensorName(); // distinct sensor names, so that a new heading does not replace an
    // unread fix
    fixes = new FixMapping(service, name + " GPS", variables.gpsDelay());
    headings =
        new HeadingMapping(
            name + " compass",
            north,
            variables.compassMountingAngle(),
            variables.headingSigma(),
            variables.compassDelay());
    gps =
        plan.gps()
            .map(pins -> variables.gps(gpsLink, pins))
            .map(each -> new DeviceReader<>(service, GPS, each, SILENT_AFTER_S));
    compass =
        plan.compass()
            .map(pins -> variables.compass(compassLink, pins))
            .map(each -> new DeviceReader<>(service, COMPASS, each, SILENT_AFTER_S));
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
      gps.flatMap(reader -> state(reader, nowMicros, fixes::state)).ifPresent(measured::add);
    }
    for (StateInformation fix : measured) {
      north.at(fix, fix.timestamp().orElseThrow());
    }
    if (compassLink.isConnected()) {
      compass.flatMap(reader -> state(reader, nowMicros, headings::state)).ifPresent(measured::add);
    }
    return measured;
  }

  private static <R extends Device.Reading> Optional<StateInformation> state(
      DeviceReader<R> reader, long nowMicros, Function<R, Optional<StateInformation>> mapping) {
    return reader
        .next(nowMicros)
        .flatMap(reading -> reader.mapped(() -> mapping.apply(reading)))
        .flatMap(state -> state);
  }

  /** Sends pending data to the devices. */
  void send(long nowMicros, Optional<FlushCounter> lockstep) throws IOException {
    gpsLink.send(nowMicros, lockstep);
    compassLink.send(nowMicros, lockstep);
  }
}
