package org.u2sa.recorder.execution;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.cbor.ByteString;

class FieldDifferenceTest {
  private static CameraImage image(int... bytes) {
    byte[] data = new byte[bytes.length];
    for (int i = 0; i < bytes.length; i++) {
      data[i] = (byte) bytes[i];
    }
    return new CameraImage()
        .sensorName("Camera")
        .format(CameraImage.JPEG)
        .data(ByteString.copyOf(data));
  }

  private static Optional<FieldDifference> difference(CameraImage recorded, CameraImage now) {
    return FieldDifference.between(recorded, now, UnaryOperator.identity());
  }

  @Test
  void between_sameBytes_isNone() {
    assertThat(difference(image(1, 255), image(1, 255))).isEmpty();
  }

  @Test
  void between_bytesThatDiffer_namesTheFirst() {
    assertThat(difference(image(1, 255, 3), image(1, 16, 4)))
        .contains(new FieldDifference("data[1]", "0xff", "0x10"));
  }

  @Test
  void between_bytesOfWhichOneGoesOn_tellsHowLongTheyAre() {
    assertThat(difference(image(1, 2), image(1)))
        .contains(new FieldDifference("data", "2 bytes", "1 byte"));
  }
}
