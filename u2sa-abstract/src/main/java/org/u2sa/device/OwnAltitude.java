package org.u2sa.device;

import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.U2SAService;

/** Altitude of the vehicle, from the state that a service subscribes to. */
final class OwnAltitude {
  private double altitudeM;

  OwnAltitude(U2SAService service) {
    service.subscribe(Channels.STATE, this::at);
  }

  private void at(StateInformation state) {
    if (state.referenceFrame().isEarth()) {
      altitudeM = state.z().orElse(altitudeM);
    }
  }

  /** Latest altitude above mean sea level [m]; 0 until known. */
  double metres() {
    return altitudeM;
  }
}
