package org.u2sa.drivers.compass;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.u2sa.device.port.Heading;
import org.u2sa.drivers.imu.VectorNav;
import org.u2sa.drivers.link.ByteParser;
import org.u2sa.drivers.nmea.Nmea;

/** Whatever a line delivers, and however it is cut: compasses and the IMU. */
class HeadingParserProperties {
  private static final int TRIES = 300;

  private enum Kind {
    NMEA,
    SPARTON,
    VECTORNAV;

    ByteParser<?> parser() {
      return switch (this) {
        case NMEA -> NmeaCompass.parser();
        case SPARTON -> new SpartonCompass();
        case VECTORNAV -> VectorNav.parser();
      };
    }
  }

  @Provide
  Arbitrary<byte[]> streams() {
    Arbitrary<byte[]> noise = Arbitraries.bytes().array(byte[].class).ofMaxSize(30);
    Arbitrary<byte[]> binary =
        Arbitraries.of(0xA4, 0x09, 0x02, 0xA0, 0x00, 0x0F, 0x10, 0xFF, 0x24)
            .map(Integer::byteValue)
            .list()
            .ofMaxSize(12)
            .map(HeadingParserProperties::array);
    Arbitrary<byte[]> sentences =
        Arbitraries.of("HCHDG", "HCHDM", "HEHDT", "VNYMR", "VNYMR,1,2,3,0,0,0,0,0,0")
            .flatMap(
                address ->
                    Arbitraries.of("", "1", "359.9", "-1", "361", "NaN", "M", "T", "W", "1e999")
                        .list()
                        .ofMaxSize(13)
                        .map(fields -> Nmea.bytes(address + "," + String.join(",", fields))));
    return Arbitraries.oneOf(noise, binary, sentences)
        .list()
        .ofMaxSize(10)
        .map(
            parts -> {
              ByteArrayOutputStream all = new ByteArrayOutputStream();
              parts.forEach(all::writeBytes);
              return all.toByteArray();
            });
  }

  private static byte[] array(List<Byte> bytes) {
    byte[] array = new byte[bytes.size()];
    for (int i = 0; i < array.length; i++) {
      array[i] = bytes.get(i);
    }
    return array;
  }

  @Property(tries = TRIES)
  void accept_anyBytes_headingsAreInATurn(@ForAll("streams") byte[] stream, @ForAll Kind kind) {
    ByteParser<?> parser = kind.parser();
    parser.accept(stream, stream.length, 0);

    if (parser.latest().orElse(null) instanceof Heading heading) {
      assertThat(heading.headingRad()).isBetween(0.0, 2.0 * Math.PI);
    }
    assertThat(parser.refused() > 0).isEqualTo(!parser.lastRefusal().isEmpty());
  }

  @Property(tries = TRIES)
  void accept_anySplit_givesTheSame(
      @ForAll("streams") byte[] stream, @ForAll List<Byte> lengths, @ForAll Kind kind) {
    ByteParser<?> whole = kind.parser();
    whole.accept(stream, stream.length, 7);
    ByteParser<?> cut = kind.parser();
    int from = 0;
    for (byte length : lengths) {
      int to = Math.min(stream.length, from + (length & 0x1F));
      cut.accept(Arrays.copyOfRange(stream, from, to), to - from, 7);
      from = to;
    }
    cut.accept(Arrays.copyOfRange(stream, from, stream.length), stream.length - from, 7);

    assertThat((Object) cut.latest()).isEqualTo(whole.latest());
    assertThat(cut.refused()).isEqualTo(whole.refused());
  }

  @Example
  void accept_deviationThatIsNoNumber_isRefused() {
    ByteParser<?> parser = Kind.NMEA.parser();
    byte[] line = "$HCHDG,1,NaN,W*6B\r\n".getBytes(StandardCharsets.US_ASCII);
    parser.accept(line, line.length, 0);

    assertThat(parser.latest()).isEmpty();
    assertThat(parser.lastRefusal()).contains("deviation NaN is outside");
  }
}
