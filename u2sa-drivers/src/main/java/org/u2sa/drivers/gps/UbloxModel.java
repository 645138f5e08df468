package org.u2sa.drivers.gps;

/** Generations of u-blox receivers that differ in what they send. */
public enum UbloxModel {
  /** LEA-6 and its kin, as in the thesis: NAV-POSLLH, NAV-VELNED, NAV-SOL. */
  UBLOX_6,
  /** u-blox 7, 8, M8, 9, M9, F9: NAV-PVT. */
  UBLOX_8
}
