package org.u2sa.device.port;

import java.util.OptionalDouble;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * A receiver's position and velocity at one time. Values not provided by the receiver are empty.
 *
 * @param measuredAtMicros time of measurement, or arrival of its first byte [µs of the run's clock]
 * @param latitudeDeg WGS 84 [deg], north positive, −90…90; 0 if not {@code valid}
 * @param longitudeDeg WGS 84 [deg], east positive, −180…180; 0 if not {@code valid}
 * @param altitudeM above mean sea level [m], up positive
 * @param eastMps east velocity over ground [m/s]
 * @param northMps north velocity over ground [m/s]
 * @param upMps up velocity [m/s]
 * @param horizontalSigmaM standard deviation of the position along each horizontal axis [m]
 * @param verticalSigmaM standard deviation of the altitude [m]
 * @param satellites number of satellites used; 0 if unknown
 * @param valid whether the receiver marks the position as valid; if not, all other numbers are
 *     meaningless
 */
public record GpsFix(
    long measuredAtMicros,
    double latitudeDeg,
    double longitudeDeg,
    OptionalDouble altitudeM,
    OptionalDouble eastMps,
    OptionalDouble northMps,
    OptionalDouble upMps,
    OptionalDouble horizontalSigmaM,
    OptionalDouble verticalSigmaM,
    int satellites,
    boolean valid)
    implements Device.Reading {

  /** A reading without a position. */
  public static GpsFix none(long measuredAtMicros, int satellites) {
    OptionalDouble unknown = OptionalDouble.empty();
    return new GpsFix(
        measuredAtMicros,
        0.0,
        0.0,
        unknown,
        unknown,
        unknown,
        unknown,
        unknown,
        unknown,
        satellites,
        false);
  }

  /** Converts a valid fix to a State Information in GLOBAL with its time, without a sensor name. */
  public StateInformation toState() {
    StateInformation state =
        new StateInformation().referenceFrame(ReferenceFrame.GLOBAL).x(longitudeDeg).y(latitudeDeg);
    altitudeM.ifPresent(state::z);
    eastMps.ifPresent(state::xDot);
    northMps.ifPresent(state::yDot);
    upMps.ifPresent(state::zDot);
    horizontalSigmaM.ifPresent(sigma -> state.xSigma(sigma).ySigma(sigma));
    verticalSigmaM.ifPresent(state::zSigma);
    state.timestamp(measuredAtMicros);
    return state;
  }
}
