package org.u2sa.drivers.gps;

import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

/** A valid fix as State Information in GLOBAL, at its own time; whose it is, is to be added. */
public final class FixedState {
  private FixedState() {}

  /** A new message. */
  public static StateInformation of(GpsFix fix) {
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.GLOBAL)
            .x(fix.longitudeDeg())
            .y(fix.latitudeDeg());
    fix.altitudeM().ifPresent(state::z);
    fix.eastMps().ifPresent(state::xDot);
    fix.northMps().ifPresent(state::yDot);
    fix.upMps().ifPresent(state::zDot);
    fix.horizontalSigmaM().ifPresent(sigma -> state.xSigma(sigma).ySigma(sigma));
    fix.verticalSigmaM().ifPresent(state::zSigma);
    state.timestamp(fix.measuredAtMicros());
    return state;
  }
}
