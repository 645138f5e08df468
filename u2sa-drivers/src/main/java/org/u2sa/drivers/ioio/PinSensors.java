package org.u2sa.drivers.ioio;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.drivers.compass.Compass;
import org.u2sa.drivers.compass.Heading;
import org.u2sa.drivers.compass.TrueNorth;
import org.u2sa.drivers.gps.FixedState;
import org.u2sa.drivers.gps.GpsFix;
import org.u2sa.drivers.gps.GpsReceiver;
import org.u2sa.drivers.link.LinkWatch;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.Sensor;

/**
 * GPS and compass at the board's UARTs, and the messages that come of them. Belongs to the
 * service's thread.
 */
final class PinSensors {
  private static final double SILENT_AFTER_S = 3.0;

  private final Sensor service;
  private final UartLink gpsLink = new UartLink();
  private final UartLink compassLink = new UartLink();
  private final Optional<GpsReceiver> gps;
  private final Optional<Compass> compass;
  private final LinkWatch gpsWatch;
  private final LinkWatch compassWatch;
  private final String gpsName; // of two sensors, or a newer heading would replace an unread fix
  private final String compassName;
  private final TrueNorth north;
  private final double mountingRad;
  private final double headingSigmaRad;
  private Optional<GpsFix> lastFix = Optional.empty();
  private Optional<Heading> lastHeading = Optional.empty();
  private String said = ""; // of the receiver's trouble
  private boolean hasFix = true; // so that its absence from the start is said, too

  /** Reads the variables that say what the devices are. */
  PinSensors(Sensor service, PinPlan plan) {
    this.service = service;
    SensorVariables variables = new SensorVariables(service);
    gps = plan.gps().map(pins -> variables.gps(gpsLink, pins));
    compass = plan.compass().map(pins -> variables.compass(compassLink, pins));
    north = variables.north();
    mountingRad = variables.mountingRad();
    headingSigmaRad = variables.headingSigmaRad();
    gpsName = service.sensorName() + " GPS";
    compassName = service.sensorName() + " compass";
    gpsWatch = new LinkWatch(service, "the GPS receiver", gpsLink, SILENT_AFTER_S);
    compassWatch = new LinkWatch(service, "the compass", compassLink, SILENT_AFTER_S);
  }

  /** Takes note of the board's pins, or that there are none now. */
  void attach(Optional<BoardPins> pins) {
    gpsLink.attach(pins.flatMap(BoardPins::gps));
    compassLink.attach(pins.flatMap(BoardPins::compass));
  }

  /**
   * Reads both.
   *
   * @return what is to be published: each fix and each heading once, at its own time
   */
  List<StateInformation> read(long nowMicros) {
    List<StateInformation> measured = new ArrayList<>(2);
    if (readGps(nowMicros) && hasFix) {
      StateInformation state = FixedState.of(lastFix.orElseThrow()).sensorName(gpsName);
      north.at(state, state.timestamp().orElseThrow());
      measured.add(state);
    }
    if (readCompass(nowMicros)) {
      state(lastHeading.orElseThrow()).ifPresent(measured::add);
    }
    return measured;
  }

  private boolean readGps(long nowMicros) {
    if (gps.isEmpty() || !gpsLink.isConnected()) {
      return false; // that the board is lost is said once, not for each device
    }
    gpsWatch.look(nowMicros);
    Optional<GpsFix> newest = gps.get().read(nowMicros).fix();
    gpsWatch.malformed(gps.get().malformed());
    sayTrouble(gps.get().trouble());
    if (newest.isEmpty() || newest.get() == lastFix.orElse(null)) {
      return false;
    }
    lastFix = newest;
    gpsWatch.heard(nowMicros);
    sayFix(newest.get());
    return true;
  }

  /** Such as a refused setup. */
  private void sayTrouble(String trouble) {
    if (!trouble.equals(said)) {
      said = trouble;
      if (!trouble.isEmpty()) {
        service.trouble(trouble);
      }
    }
  }

  private void sayFix(GpsFix newest) {
    if (newest.valid() == hasFix) {
      return;
    }
    hasFix = newest.valid();
    if (hasFix) {
      service.log("the GPS receiver has a fix");
    } else {
      service.trouble("the GPS receiver has no fix (" + newest.satellites() + " satellites)");
    }
  }

  private boolean readCompass(long nowMicros) {
    if (compass.isEmpty() || !compassLink.isConnected()) {
      return false;
    }
    compassWatch.look(nowMicros);
    Optional<Heading> newest = compass.get().read(nowMicros).heading();
    compassWatch.malformed(compass.get().malformed());
    if (newest.isEmpty() || newest.get() == lastHeading.orElse(null)) {
      return false;
    }
    lastHeading = newest;
    compassWatch.heard(nowMicros);
    return true;
  }

  private Optional<StateInformation> state(Heading heading) {
    OptionalDouble psi = north.of(heading, -mountingRad);
    if (psi.isEmpty()) {
      return Optional.empty(); // true north is not known before the first fix
    }
    StateInformation state =
        new StateInformation()
            .sensorName(compassName)
            .referenceFrame(ReferenceFrame.GLOBAL)
            .psi(psi.getAsDouble())
            .psiSigma(headingSigmaRad);
    state.timestamp(heading.measuredAtMicros());
    return Optional.of(state);
  }

  /** Sends what is to go to the devices. */
  void send(long nowMicros, Optional<FlushCounter> lockstep) throws IOException {
    gpsLink.send(nowMicros, lockstep);
    compassLink.send(nowMicros, lockstep);
  }
}
