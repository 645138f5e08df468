package org.u2sa.drivers.gps;

import org.u2sa.device.port.GpsFix;
import org.u2sa.drivers.link.ByteParser;

/**
 * A u-blox receiver using the UBX protocol: NAV-PVT (u-blox 7 and later), or NAV-POSLLH, NAV-VELNED
 * and NAV-SOL or NAV-STATUS of one time of week (LEA-6 and older). Formats: u-blox 6 Receiver
 * Description GPS.G6-SW-10018, u-blox 8 / M8 Receiver Description UBX-13003221.
 */
public final class UbxGps extends ByteParser<GpsFix> {
  static final int NAV_POSLLH = 0x0102;
  static final int NAV_STATUS = 0x0103;
  static final int NAV_SOL = 0x0106;
  static final int NAV_PVT = 0x0107;
  static final int NAV_VELNED = 0x0112;
  static final int ACK_NAK = 0x0500;
  static final int ACK_ACK = 0x0501;

  private static final int POSLLH_LENGTH = 28;
  private static final int STATUS_LENGTH = 16;
  private static final int SOL_LENGTH = 52;
  private static final int PVT_LENGTH = 84; // u-blox 7; 92 since u-blox 8
  private static final int VELNED_LENGTH = 36;
  private static final int ACK_LENGTH = 2;

  private static final double DEG_PER_UNIT = 1e-7;
  private static final double M_PER_MM = 1e-3;
  private static final double MPS_PER_CMPS = 1e-2;

  private final UbxFramer framer = new UbxFramer(this::take, this::refuse);
  private final UbxEpoch epoch = new UbxEpoch();
  private Acknowledgements acknowledgements = (kind, isAccepted) -> {};
  private long nowMicros;

  /** Receives acknowledgements. */
  @FunctionalInterface
  interface Acknowledgements {
    /**
     * @param kind class and id of the acknowledged message
     */
    void answered(int kind, boolean isAccepted);
  }

  void answersTo(Acknowledgements listener) {
    acknowledgements = listener;
  }

  @Override
  public void accept(byte[] bytes, int length, long now) {
    nowMicros = now;
    framer.accept(bytes, length);
  }

  private void take(UbxPayload message) {
    try {
      switch (message.kind()) {
        case NAV_PVT -> takePvt(message);
        case NAV_POSLLH -> takePosition(message);
        case NAV_VELNED -> takeVelocity(message);
        case NAV_SOL -> {
          require(message, SOL_LENGTH);
          epoch.at(message.u4(0), nowMicros).status(message.u1(10), message.u1(11), message.u1(47));
          tellIfWhole();
        }
        case NAV_STATUS -> {
          require(message, STATUS_LENGTH);
          epoch.at(message.u4(0), nowMicros).status(message.u1(4), message.u1(5), 0);
          tellIfWhole();
        }
        case ACK_ACK, ACK_NAK -> {
          require(message, ACK_LENGTH);
          acknowledgements.answered(message.u1(0) << 8 | message.u1(1), message.kind() == ACK_ACK);
        }
        default -> {} // not requested
      }
    } catch (IllegalArgumentException e) {
      refuse(String.format("UBX message %04X: %s", message.kind(), e.getMessage()));
    }
  }

  private static void require(UbxPayload message, int length) {
    if (message.length() < length) {
      throw new IllegalArgumentException(
          "payload of " + message.length() + " bytes, expected " + length);
    }
  }

  private void takePvt(UbxPayload message) {
    require(message, PVT_LENGTH);
    epoch.clear(); // each message is an epoch
    epoch
        .at(message.u4(0), nowMicros)
        .position(
            DEG_PER_UNIT * message.i4(28),
            DEG_PER_UNIT * message.i4(24),
            M_PER_MM * message.i4(36),
            HorizontalError.perAxisM(M_PER_MM * message.u4(40)),
            M_PER_MM * message.u4(44));
    epoch.velocity(
        M_PER_MM * message.i4(52), M_PER_MM * message.i4(48), -M_PER_MM * message.i4(56));
    epoch.status(message.u1(20), message.u1(21), message.u1(23));
    tellIfWhole();
  }

  private void takePosition(UbxPayload message) {
    require(message, POSLLH_LENGTH);
    epoch
        .at(message.u4(0), nowMicros)
        .position(
            DEG_PER_UNIT * message.i4(8),
            DEG_PER_UNIT * message.i4(4),
            M_PER_MM * message.i4(16),
            HorizontalError.perAxisM(M_PER_MM * message.u4(20)),
            M_PER_MM * message.u4(24));
    tellIfWhole();
  }

  private void takeVelocity(UbxPayload message) {
    require(message, VELNED_LENGTH);
    epoch
        .at(message.u4(0), nowMicros)
        .velocity(
            MPS_PER_CMPS * message.i4(8),
            MPS_PER_CMPS * message.i4(4),
            -MPS_PER_CMPS * message.i4(12));
    tellIfWhole();
  }

  private void tellIfWhole() {
    if (epoch.isWhole()) {
      found(epoch.take());
    }
  }

  @Override
  public void reset() {
    framer.reset();
    epoch.clear();
  }
}
