package org.u2sa.scenarios.suas;

import java.util.Arrays;
import org.u2sa.sim.vehicle.VehicleTruth;

/** Paints what the camera sees of the field. */
final class FieldPainter {
  private byte[] plain = new byte[0];

  byte[] picture(SurveyPictures.Optics optics, VehicleTruth truth) {
    int bytes = 3 * optics.width() * optics.height();
    if (plain.length != bytes) {
      plain = new byte[bytes];
      Arrays.fill(plain, (byte) 90);
    }
    return plain;
  }
}
