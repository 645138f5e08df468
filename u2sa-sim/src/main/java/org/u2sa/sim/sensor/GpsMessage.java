package org.u2sa.sim.sensor;

/** Messages a u-blox receiver can send after each position, by UBX class and id. */
public enum GpsMessage {
  /** NMEA: position, quality, altitude. */
  GGA(0xF0, 0x00),
  /** NMEA: position, speed, course, date. */
  RMC(0xF0, 0x04),
  /** NMEA: course and speed. */
  VTG(0xF0, 0x05),
  /** NMEA: standard deviations. */
  GST(0xF0, 0x07),
  /** UBX: position and its accuracy. */
  POSLLH(UbxGpsMessages.NAV, UbxGpsMessages.POSLLH),
  /** UBX: fix type. */
  STATUS(UbxGpsMessages.NAV, UbxGpsMessages.STATUS),
  /** UBX: fix type, satellites, ECEF position and velocity. */
  SOL(UbxGpsMessages.NAV, UbxGpsMessages.SOL),
  /** UBX: velocity and its accuracy. */
  VELNED(UbxGpsMessages.NAV, UbxGpsMessages.VELNED),
  /** UBX: complete navigation solution, u-blox 7 and later. */
  PVT(UbxGpsMessages.NAV, UbxGpsMessages.PVT);

  private static final int NMEA = 0xF0;

  private final int messageClass;
  private final int id;

  GpsMessage(int messageClass, int id) {
    this.messageClass = messageClass;
    this.id = id;
  }

  boolean isNmea() {
    return messageClass == NMEA;
  }

  boolean is(int otherClass, int otherId) {
    return messageClass == otherClass && id == otherId;
  }
}
