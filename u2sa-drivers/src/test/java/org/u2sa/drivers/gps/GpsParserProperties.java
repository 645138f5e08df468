package org.u2sa.drivers.gps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.u2sa.device.port.GpsFix;
import org.u2sa.drivers.link.ByteParser;
import org.u2sa.drivers.nmea.Nmea;

/** Whatever a line delivers, and however it is cut. */
class GpsParserProperties {
  private static final int TRIES = 300;

  private static ByteParser<GpsFix> parser(boolean isUbx) {
    return isUbx ? new UbxGps() : new NmeaGps();
  }

  /** Whole messages, broken ones and noise, in any order. */
  @Provide
  Arbitrary<byte[]> streams() {
    Arbitrary<byte[]> noise = Arbitraries.bytes().array(byte[].class).ofMaxSize(40);
    Arbitrary<String> text =
        Arbitraries.strings().withChars("0123456789.,*$AVNSEWGPRMCTHD\r\n").ofMaxLength(80);
    Arbitrary<byte[]> sentences = text.map(body -> Nmea.bytes(body.replaceAll("[$*\r\n]", "")));
    Arbitrary<byte[]> plausible =
        Arbitraries.of("RMC", "GGA", "GST", "GSA", "VTG")
            .flatMap(
                kind ->
                    Arbitraries.of(
                            "", "A", "V", "N", "1", "3713.5", "120000", "120001", "99.9", "-7")
                        .list()
                        .ofMaxSize(20)
                        .map(fields -> Nmea.bytes("GP" + kind + "," + String.join(",", fields))));
    Arbitrary<byte[]> good =
        Arbitraries.integers()
            .between(0, 59)
            .map(
                second ->
                    Nmea.bytes(
                        String.format(
                            "GPRMC,1200%02d.00,A,3713.5000,N,08025.2000,W,1.0,9.0,211126,,,A",
                            second)));
    Arbitrary<byte[]> ubx =
        Arbitraries.of("NAV-PVT", "NAV-POSLLH", "NAV-VELNED", "NAV-SOL", "NAV-STATUS", "ACK-ACK")
            .map(UbxGolden::of);
    Arbitrary<byte[]> strangeUbx =
        Combinators.combine(
                Arbitraries.of("NAV-PVT", "NAV-POSLLH", "NAV-VELNED", "NAV-SOL"),
                Arbitraries.integers().between(0, 26),
                Arbitraries.integers().between(0, 255))
            .as(UbxGolden::changed);
    Arbitrary<byte[]> cutUbx =
        Combinators.combine(ubx, Arbitraries.integers().between(1, 99))
            .as((whole, length) -> Arrays.copyOf(whole, Math.min(whole.length, length)));
    return Arbitraries.oneOf(
            noise, ubx, strangeUbx, cutUbx, text.map(String::getBytes), sentences, plausible, good)
        .list()
        .ofMaxSize(12)
        .map(GpsParserProperties::joined);
  }

  private static byte[] joined(List<byte[]> parts) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    parts.forEach(all::writeBytes);
    return all.toByteArray();
  }

  @Property(tries = TRIES)
  void accept_anyBytes_neverThrows(@ForAll("streams") byte[] stream, @ForAll boolean isUbx) {
    ByteParser<GpsFix> parser = parser(isUbx);
    parser.accept(stream, stream.length, 0);

    parser
        .latest()
        .filter(GpsFix::valid)
        .ifPresent(
            fix -> {
              assertThat(fix.latitudeDeg()).isBetween(-90.0, 90.0);
              assertThat(fix.longitudeDeg()).isBetween(-180.0, 180.0);
            });
    assertThat(parser.refused() > 0).isEqualTo(!parser.lastRefusal().isEmpty());
  }

  @Property(tries = TRIES)
  void accept_anySplit_givesTheSameFix(
      @ForAll("streams") byte[] stream, @ForAll List<Byte> lengths, @ForAll boolean isUbx) {
    ByteParser<GpsFix> whole = parser(isUbx);
    whole.accept(stream, stream.length, 7);

    ByteParser<GpsFix> cut = parser(isUbx);
    int from = 0;
    for (byte length : lengths) {
      int to = Math.min(stream.length, from + (length & 0xFF));
      cut.accept(Arrays.copyOfRange(stream, from, to), to - from, 7);
      from = to;
    }
    cut.accept(Arrays.copyOfRange(stream, from, stream.length), stream.length - from, 7);

    assertThat(cut.latest()).isEqualTo(whole.latest());
    assertThat(cut.refused()).isEqualTo(whole.refused());
  }

  @Property(tries = TRIES)
  void accept_goodAfterAnything_isUnderstood(
      @ForAll("streams") byte[] stream, @ForAll boolean isUbx) {
    ByteParser<GpsFix> parser = parser(isUbx);
    parser.accept(stream, stream.length, 0);
    ByteArrayOutputStream good = new ByteArrayOutputStream();
    for (int i = 0; i < 15; i++) { // more than the longest message that may be waited for
      good.writeBytes(
          isUbx
              ? UbxGolden.of("NAV-PVT")
              : Nmea.bytes(
                  "GPRMC,13" + (10 + i) + "00.00,A,3713.7744,N,02000.0000,E,1,9.0,211126,,,A"));
    }
    byte[] bytes = good.toByteArray();
    parser.accept(bytes, bytes.length, 1);

    GpsFix fix = parser.latest().orElseThrow();
    assertThat(fix.latitudeDeg()).isCloseTo(37.22957, within(1e-5));
    assertThat(fix.measuredAtMicros()).isEqualTo(1);
  }
}
