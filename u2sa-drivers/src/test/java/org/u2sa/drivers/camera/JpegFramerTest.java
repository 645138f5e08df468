package org.u2sa.drivers.camera;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.u2sa.device.port.CameraFrame;

class JpegFramerTest {
  private final JpegFramer framer = new JpegFramer();
  private final byte[] jpeg = Jpegs.darkThenBright(320, 240);

  private void say(byte[] bytes, long nowMicros) {
    framer.accept(bytes, bytes.length, nowMicros);
  }

  @Test
  void accept_pictureAmongWords_isThatPictureAtTheTimeOfItsFirstByte() {
    say(Jpegs.head(), 1);
    say("--b\r\n\r\n".getBytes(US_ASCII), 2);
    say(Arrays.copyOf(jpeg, 100), 3);
    assertThat(framer.latest()).isEmpty();
    say(Arrays.copyOfRange(jpeg, 100, jpeg.length), 4);
    CameraFrame frame = framer.latest().orElseThrow();
    assertThat(frame.pixels()).isEqualTo(jpeg);
    assertThat(frame.width()).isEqualTo(320);
    assertThat(frame.height()).isEqualTo(240);
    assertThat(frame.measuredAtMicros()).isEqualTo(3);
    assertThat(frame.format()).isEqualTo(CameraFrame.PixelFormat.JPEG);
    assertThat(framer.refused()).isZero();
  }

  @Test
  void accept_thumbnailInTheHeader_doesNotEndThePicture() {
    byte[] thumbnail = Jpegs.darkThenBright(16, 16);
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    file.write(jpeg, 0, 2);
    int length = thumbnail.length + 2;
    file.writeBytes(new byte[] {(byte) 0xFF, (byte) 0xE1, (byte) (length >> 8), (byte) length});
    file.writeBytes(thumbnail);
    file.write(jpeg, 2, jpeg.length - 2);
    say(file.toByteArray(), 1);
    assertThat(framer.latest().orElseThrow().width()).isEqualTo(320);
    assertThat(framer.latest().orElseThrow().pixels()).isEqualTo(file.toByteArray());
  }

  @Test
  void accept_cutPicture_isPassedOverAndTheNextOneIsSeen() {
    say(Jpegs.part(Arrays.copyOf(jpeg, jpeg.length / 2)), 1);
    say(Jpegs.part(jpeg), 2);
    say(Jpegs.part(jpeg), 3);
    assertThat(framer.latest().orElseThrow().pixels()).isEqualTo(jpeg);
  }
}
