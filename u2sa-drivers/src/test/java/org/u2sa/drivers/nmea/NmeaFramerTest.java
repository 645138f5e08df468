package org.u2sa.drivers.nmea;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class NmeaFramerTest {
  /** Example of u-blox's protocol specification, GPS.G6-SW-10018, RMC. */
  private static final String RMC =
      "$GPRMC,083559.00,A,4717.11437,N,00833.91522,E,0.004,77.52,091202,,,A*57";

  private final List<String> sentences = new ArrayList<>();
  private final List<String> refusals = new ArrayList<>();
  private final NmeaFramer framer =
      new NmeaFramer(sentence -> sentences.add(sentence.text()), refusals::add);

  private void accept(String text) {
    byte[] bytes = text.getBytes(ISO_8859_1);
    framer.accept(bytes, bytes.length);
  }

  @Test
  void accept_publishedExample_isTakenWhole() {
    accept(RMC + "\r\n");

    assertThat(sentences).containsExactly(RMC);
    assertThat(refusals).isEmpty();
  }

  @Test
  void accept_wrongChecksum_isRefusedAndTheNextTaken() {
    accept(RMC.replace("*57", "*58") + "\r\n" + RMC + "\n");

    assertThat(sentences).containsExactly(RMC);
    assertThat(refusals)
        .singleElement()
        .asString()
        .startsWith("wrong checksum: $GPRMC")
        .endsWith("*58");
  }

  @Test
  void accept_checksumInSmallLetters_isTaken() {
    accept("$GPGST,082356.00,1.8,,,,1.7,1.3,2.2*7e\r\n");

    assertThat(sentences).hasSize(1);
  }

  @Test
  void accept_noChecksum_isRefused() {
    accept("$GPRMC,083559.00,A\r\n");

    assertThat(sentences).isEmpty();
    assertThat(refusals).containsExactly("no checksum: $GPRMC,083559.00,A");
  }

  @Test
  void accept_cutOffByTheNext_nextIsTaken() {
    accept("$GPRMC,0835" + RMC + "\r\n");

    assertThat(sentences).containsExactly(RMC);
    assertThat(refusals).containsExactly("cut off: $GPRMC,0835");
  }

  @Test
  void accept_endless_isGivenUp() {
    accept("$" + "A".repeat(10_000) + "\r\n" + RMC + "\r\n");

    assertThat(sentences).containsExactly(RMC);
    assertThat(refusals).singleElement().asString().startsWith("longer than 255 characters: $AAA");
  }

  @Test
  void accept_binaryInBetween_isPassedOver() {
    accept("\u00b5b\u0001\u0002$GP\u0000\u00ff" + RMC + "\r\n");

    assertThat(sentences).containsExactly(RMC);
    assertThat(refusals).containsExactly("not text: $GP");
  }

  @Test
  void field_emptyAndMissingOnes_areEmpty() {
    List<String> fields = new ArrayList<>();
    byte[] bytes = Nmea.bytes("HCHDG,101.1,,,7.1,W");
    NmeaFramer reader =
        new NmeaFramer(
            sentence -> {
              for (int i = 0; i <= 7; i++) {
                fields.add(sentence.field(i));
              }
              assertThat(sentence.is("HDG")).isTrue();
              assertThat(sentence.is("HD")).isFalse();
              assertThat(sentence.isAddressed("HCHDG")).isTrue();
            },
            refusals::add);
    reader.accept(bytes, bytes.length);

    assertThat(fields).containsExactly("$HCHDG", "101.1", "", "", "7.1", "W", "", "");
  }
}
