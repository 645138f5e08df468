package org.u2sa.gcs.mavlink.parameter;

import io.dronefleet.mavlink.common.MavParamType;

/**
 * The two encodings of integers in PARAM_VALUE and PARAM_SET (mavlink.io/en/services/parameter):
 * their bits in place of a float's, or their value cast to float.
 */
final class ParameterEncoding {
  private ParameterEncoding() {}

  static float encode(Parameter.Value value, boolean casts) {
    boolean isFloat = value.type() == MavParamType.MAV_PARAM_TYPE_REAL32;
    return isFloat || casts ? (float) value.number() : Float.intBitsToFloat((int) value.number());
  }

  /**
   * Number that a station sends.
   *
   * @param type type that it states
   */
  static double decode(float wire, MavParamType type, boolean casts) {
    if (casts || type == null || type == MavParamType.MAV_PARAM_TYPE_REAL32) {
      return wire;
    }
    int bits = Float.floatToRawIntBits(wire);
    return switch (type) {
      case MAV_PARAM_TYPE_UINT8 -> bits & 0xFF;
      case MAV_PARAM_TYPE_INT8 -> (byte) bits;
      case MAV_PARAM_TYPE_UINT16 -> bits & 0xFFFF;
      case MAV_PARAM_TYPE_INT16 -> (short) bits;
      case MAV_PARAM_TYPE_UINT32 -> Integer.toUnsignedLong(bits);
      default -> bits;
    };
  }
}
