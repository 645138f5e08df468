package org.u2sa.drivers.gps;

import java.util.List;

/** u-blox receiver generations by their message sets. */
public enum UbloxModel {
  /** LEA-6 generation, as in the thesis: NAV-POSLLH, NAV-VELNED, NAV-SOL. */
  UBLOX_6(UbxGps.NAV_POSLLH, UbxGps.NAV_VELNED, UbxGps.NAV_SOL),
  /** u-blox 7, 8, M8, 9, M9, F9: NAV-PVT. */
  UBLOX_8(UbxGps.NAV_PVT);

  private final List<Integer> messages;

  UbloxModel(Integer... messages) {
    this.messages = List.of(messages);
  }

  /** Model by configuration name, such as {@code UBLOX 6}. */
  public static UbloxModel named(String name) {
    return valueOf(name.replace(' ', '_'));
  }

  /** Class and id of each message to send once per solution. */
  List<Integer> messages() {
    return messages;
  }
}
