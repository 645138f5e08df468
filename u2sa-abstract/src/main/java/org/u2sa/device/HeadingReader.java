package org.u2sa.device;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.Compass;
import org.u2sa.device.port.Heading;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.U2SAService;

/** Reads a compass for a service, and converts its headings to true headings of the vehicle. */
public final class HeadingReader {
  private final String sensorName;
  private final DeviceReader<Heading> reader;
  private final TrueNorth north;
  private final double mountingRad;
  private final double sigmaRad;
  private final long delayMicros;
  private boolean waits;

  /**
   * @param sensorName sensor name for messages
   * @param silentAfterS time without a reading after which the compass counts as silent [s]
   * @param north converts its headings to true ones
   * @param mountingRad direction of the compass's front, clockwise from the vehicle's [rad]
   * @param sigmaRad standard deviation of a heading [rad]
   * @param delayS latency from a heading's validity to its reading's timestamp [s]
   */
  public HeadingReader(
      U2SAService service,
      Compass compass,
      String sensorName,
      double silentAfterS,
      TrueNorth north,
      double mountingRad,
      double sigmaRad,
      double delayS) {
    this.sensorName = sensorName;
    reader = new DeviceReader<>(service, "the compass", compass, silentAfterS);
    this.north = north;
    this.mountingRad = mountingRad;
    this.sigmaRad = sigmaRad;
    delayMicros = Clock.micros(delayS);
  }

  /** Sets the vehicle's position for the declination, like {@link TrueNorth#at}. */
  public void at(StateInformation state, long nowMicros) {
    north.at(state, nowMicros);
  }

  /**
   * Returns the state from a new heading, in GLOBAL, timestamped with its validity, for publishing;
   * call it at each step.
   */
  public Optional<StateInformation> next(long nowMicros) {
    Optional<Heading> heading = reader.next(nowMicros);
    Optional<StateInformation> state = heading.flatMap(this::state);
    waits = heading.isPresent() && state.isEmpty();
    return state;
  }

  /**
   * Whether the last call of {@link #next} dropped a heading because true north is not known yet.
   */
  public boolean waitsForPosition() {
    return waits;
  }

  private Optional<StateInformation> state(Heading heading) {
    OptionalDouble psi = north.of(heading, -mountingRad);
    if (psi.isEmpty()) {
      return Optional.empty();
    }
    StateInformation state =
        new StateInformation()
            .sensorName(sensorName)
            .referenceFrame(ReferenceFrame.GLOBAL)
            .psi(psi.getAsDouble())
            .psiSigma(sigmaRad);
    state.timestamp(heading.measuredAtMicros() - delayMicros);
    return Optional.of(state);
  }
}
