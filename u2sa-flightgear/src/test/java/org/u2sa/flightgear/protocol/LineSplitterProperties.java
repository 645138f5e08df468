package org.u2sa.flightgear.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.AlphaChars;
import net.jqwik.api.constraints.Size;

final class LineSplitterProperties {
  private final LineSplitter splitter = new LineSplitter();
  private final List<String> lines = new ArrayList<>();
  private final List<String> tooLong = new ArrayList<>();

  @Property(tries = 200)
  void feed_linesCutIntoAnyPackets_givesTheLines(
      @ForAll @Size(max = 20) List<@AlphaChars String> sent, @ForAll Random random) {
    LineSplitter fresh = new LineSplitter();
    List<String> got = new ArrayList<>();
    byte[] bytes =
        sent.stream()
            .map(each -> each + "\n")
            .reduce("", String::concat)
            .getBytes(StandardCharsets.US_ASCII);
    for (int at = 0; at < bytes.length; ) {
      int length = Math.min(bytes.length - at, 1 + random.nextInt(10));
      fresh.feed(ByteBuffer.wrap(bytes, at, length), got::add, each -> got.add("too long"));
      at += length;
    }
    assertThat(got).isEqualTo(sent);
    assertThat(fresh.isInsideLine()).isFalse();
  }

  @Example
  void feed_endlessLine_isReportedOnceAndTheNextLineIsRead() {
    for (int i = 0; i < 100; i++) {
      feed("x".repeat(1_000));
    }
    assertThat(splitter.isInsideLine()).isTrue();
    feed("\ngood\n");
    assertThat(tooLong).hasSize(1);
    assertThat(lines).containsExactly("good");
  }

  @Example
  void feed_carriageReturn_belongsToTheLineEnd() {
    feed("a\r\nb\n\r\n");
    assertThat(lines).containsExactly("a", "b", "");
  }

  @Example
  void feed_halfALine_waitsForTheRest() {
    feed("1,2");
    assertThat(lines).isEmpty();
    assertThat(splitter.isInsideLine()).isTrue();
    feed(",3\n");
    assertThat(lines).containsExactly("1,2,3");
  }

  private void feed(String text) {
    splitter.feed(
        ByteBuffer.wrap(text.getBytes(StandardCharsets.US_ASCII)), lines::add, tooLong::add);
  }
}
