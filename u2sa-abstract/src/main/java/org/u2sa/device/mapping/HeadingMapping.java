package org.u2sa.device.mapping;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.Heading;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

/** Maps a compass's headings to states with the true heading of the vehicle. */
public final class HeadingMapping {
  private final String sensorName;
  private final TrueNorth north;
  private final double mountingRad;
  private final double sigmaRad;
  private final long delayMicros;

  /**
   * @param mountingRad direction of the compass's front, clockwise from the vehicle's [rad]
   * @param sigmaRad standard deviation of a heading [rad]
   * @param delayS latency from a heading's validity to its reading's timestamp [s]
   */
  public HeadingMapping(
      String sensorName, TrueNorth north, double mountingRad, double sigmaRad, double delayS) {
    this.sensorName = sensorName;
    this.north = north;
    this.mountingRad = mountingRad;
    this.sigmaRad = sigmaRad;
    delayMicros = Clock.micros(delayS);
  }

  /**
   * State in GLOBAL, timestamped with the validity of the heading; empty while true north is
   * unknown.
   */
  public Optional<StateInformation> state(Heading heading) {
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
