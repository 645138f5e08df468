package org.u2sa.sim.sensor;

/** A message that a u-blox receiver can send after each position, by its UBX class and id. */
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
  /** UBX: kind of fix. */
  STATUS(UbxGpsMessages.NAV, UbxGpsMessages.STATUS),
  /** UBX: kind of fix, satellites, position and velocity in the earth's axes. */
  SOL(UbxGpsMessages.NAV, UbxGpsMessages.SOL),
  /** UBX: velocity and its accuracy. */
  VELNED(UbxGpsMessages.NAV, UbxGpsMessages.VELNED),
  /** UBX: all in one, from u-blox 7 on. */
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
