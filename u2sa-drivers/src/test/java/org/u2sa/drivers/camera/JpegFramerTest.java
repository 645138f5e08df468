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
  void accept_pictureThatTheHeapCannotHoldDecoded_isRefused() {
    JpegFramer small = new JpegFramer(320 * 240 * 24 - 1);
    small.accept(jpeg, jpeg.length, 1);

    assertThat(small.latest()).isEmpty();
    assertThat(small.refused()).isEqualTo(1);
  }

  private static int marker(byte[] jpeg, int marker) {
    int at = 0;
    while ((jpeg[at] & 0xFF) != 0xFF || (jpeg[at + 1] & 0xFF) != marker) {
      at++;
    }
    return at;
  }

  /** A picture of 4096 by 4096 pixels in a number of scans; a decoder needs 60 ms for each. */
  private byte[] large(int scans) {
    byte[] large = jpeg.clone();
    int size = marker(large, 0xC0) + 5;
    for (int i = 0; i < 4; i += 2) {
      large[size + i] = 0x10;
      large[size + i + 1] = 0;
    }
    int scan = marker(large, 0xDA);
    int end = scan + 2 + (large[scan + 2] << 8 | large[scan + 3]);
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    file.write(large, 0, scan);
    for (int i = 0; i < scans; i++) {
      file.write(large, scan, end - scan);
      file.write(0);
    }
    file.writeBytes(new byte[] {(byte) 0xFF, (byte) 0xD9});
    return file.toByteArray();
  }

  @Test
  void accept_pictureOfManyScans_isRefusedAndTheNextOneIsSeen() {
    say(large(8), 1);
    assertThat(framer.latest().orElseThrow().width()).isEqualTo(4096);
    assertThat(framer.refused()).isZero();

    say(large(1000), 2);
    say(jpeg, 3);
    assertThat(framer.latest().orElseThrow().pixels()).isEqualTo(jpeg);
    assertThat(framer.refused()).isPositive();
  }

  @Test
  void accept_cutPicture_isPassedOverAndTheNextOneIsSeen() {
    say(Jpegs.part(Arrays.copyOf(jpeg, jpeg.length / 2)), 1);
    say(Jpegs.part(jpeg), 2);
    say(Jpegs.part(jpeg), 3);
    assertThat(framer.latest().orElseThrow().pixels()).isEqualTo(jpeg);
  }
}
