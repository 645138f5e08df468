package org.u2sa.sim.sensor;

/** Finds UBX messages in what a host sends; anything else is passed over, as the receivers do. */
final class UbxRequests {
  private static final int LONGEST = 512;

  /** Takes one message whose checksum is right. */
  interface Listener {
    void request(int messageClass, int id, byte[] payload);
  }

  private final Listener listener;
  private final byte[] message = new byte[UbxMessage.HEADER + LONGEST + UbxMessage.CHECKSUM];
  private int size;

  UbxRequests(Listener listener) {
    this.listener = listener;
  }

  void accept(byte[] bytes, int length) {
    for (int i = 0; i < length; i++) {
      accept(bytes[i]);
    }
  }

  private void accept(byte octet) {
    message[size++] = octet;
    if (size == 1 && (octet & 0xFF) != UbxMessage.SYNC_1
        || size == 2 && (octet & 0xFF) != UbxMessage.SYNC_2) {
      size = (octet & 0xFF) == UbxMessage.SYNC_1 ? 1 : 0;
      message[0] = octet;
      return;
    }
    if (size < UbxMessage.HEADER) {
      return;
    }
    int length = message[4] & 0xFF | (message[5] & 0xFF) << 8;
    if (length > LONGEST) {
      size = 0;
    } else if (size == UbxMessage.HEADER + length + UbxMessage.CHECKSUM) {
      size = 0;
      finish(length);
    }
  }

  private void finish(int length) {
    int end = UbxMessage.HEADER + length;
    int said = (message[end] & 0xFF) << 8 | message[end + 1] & 0xFF;
    if (UbxMessage.checksum(message, 2, end) == said) {
      byte[] payload = new byte[length];
      System.arraycopy(message, UbxMessage.HEADER, payload, 0, length);
      listener.request(message[2] & 0xFF, message[3] & 0xFF, payload);
    }
  }
}
