package org.u2sa.recorder.mcap;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.Base64;
import java.util.Random;
import net.jpountz.lz4.LZ4Factory;
import net.jpountz.lz4.LZ4FrameOutputStream;
import net.jpountz.xxhash.XXHashFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class Lz4FrameTest {
  /** Bytes of which {@code random} in 256 are random; the others repeat. */
  private static byte[] bytes(int length, int random) {
    Random source = new Random(length);
    byte[] bytes = new byte[length];
    for (int i = 0; i < length; i++) {
      bytes[i] = (byte) (source.nextInt(256) < random ? source.nextInt(256) : i / 7);
    }
    return bytes;
  }

  /** The library's own frame, by its compressor with all checks. */
  private static byte[] expected(byte[] bytes) throws IOException {
    ByteArrayOutputStream frame = new ByteArrayOutputStream();
    try (OutputStream out =
        new LZ4FrameOutputStream(
            frame,
            LZ4FrameOutputStream.BLOCKSIZE.SIZE_64KB,
            -1L,
            LZ4Factory.safeInstance().fastCompressor(),
            XXHashFactory.safeInstance().hash32(),
            LZ4FrameOutputStream.FLG.Bits.BLOCK_INDEPENDENCE)) {
      out.write(bytes);
    }
    return frame.toByteArray();
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 11, 65_535, 65_536, 65_537, 300_000})
  void write_anyLength_isTheLibrarysFrame(int length) throws IOException {
    for (int random : new int[] {0, 64, 256}) {
      byte[] bytes = bytes(length, random);
      byte[] to = new byte[3 + Lz4Frame.longest(length)];
      int end = Lz4Frame.write(bytes, length, to, 3);
      byte[] frame = Arrays.copyOfRange(to, 3, end);
      assertThat(frame).isEqualTo(expected(bytes));
      assertThat(Lz4Frame.read(frame, length)).isEqualTo(bytes);
    }
  }

  @Test
  void read_cutOffOrOfAnotherLength_isRefused() throws IOException {
    byte[] bytes = bytes(70_000, 64);
    byte[] frame = expected(bytes);
    for (int length = 0; length < frame.length; length += 97) {
      assertThat(Lz4Frame.read(Arrays.copyOf(frame, length), bytes.length)).isNull();
    }
    for (long size : new long[] {-1, 0, bytes.length - 1, bytes.length + 1, Long.MAX_VALUE}) {
      assertThat(Lz4Frame.read(frame, size)).isNull();
    }
  }

  @Test
  void read_oneByteChanged_neverFails() throws IOException {
    byte[] bytes = bytes(3_000, 64);
    byte[] frame = expected(bytes);
    for (int i = 0; i < frame.length; i++) {
      byte[] changed = frame.clone();
      changed[i] ^= 0x55;
      byte[] read = Lz4Frame.read(changed, bytes.length);
      assertThat(read == null || read.length == bytes.length).isTrue();
    }
  }

  /** 140,000 bytes by the LZ4 library 1.9.4 with its defaults, but blocks of 64 KiB. */
  private static final String LINKED =
      "BCJNGExA4CICAAAAAAD9HwEAAP8FVTJTQSBsaW5rZWQgYmxvY2tzLiAUAP////////////////////////////////////////////////////"
          + "//////////////////////////////////////////////////////////////////////////////////////////////////////////////"
          + "//////////////////////////////////////////////////////////////////////////////////////////////////////////////"
          + "/////////////////////////////////////////////////////////////////////UUCBibG9jCgEAAA/w////////////////////////"
          + "//////////////////////////////////////////////////////////////////////////////////////////////////////////////"
          + "//////////////////////////////////////////////////////////////////////////////////////////////////////////////"
          + "///////////////////////////////////////////////////////////////////////////////////////////////////oUG5rZWQgLA"
          + "AAAA8UAP/////////////////////////////////////////////qUGNrcy4gAAAAANBpO6k=";

  @Test
  void read_linkedBlocksOfTheLz4Library_areTheBytes() {
    byte[] frame = Base64.getDecoder().decode(LINKED);
    String text = "U2SA linked blocks. ".repeat(7_000);

    assertThat(Lz4Frame.read(frame, text.length())).isEqualTo(text.getBytes(US_ASCII));
    assertThat(
            ChunkCompression.LZ4.decompressPrefix(frame, text.length()).bytes()) // as in recovery
        .isEqualTo(text.getBytes(US_ASCII));
    assertThat(Lz4Frame.read(frame, text.length() - 1)).isNull();
    for (int length = 0; length < frame.length - 8; length++) {
      assertThat(Lz4Frame.read(Arrays.copyOf(frame, length), text.length())).isNull();
    }
    for (int i = 0; i < frame.length; i++) {
      byte[] changed = frame.clone();
      changed[i] ^= 0x55;
      byte[] read = Lz4Frame.read(changed, text.length());
      assertThat(read == null || read.length == text.length()).isTrue();
    }
  }
}
