package org.u2sa.drivers.wind;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.device.port.Anemometer;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.nmea.Nmea;

class NmeaAnemometerTest {
  private final MemoryLink link = new MemoryLink();
  private final NmeaAnemometer nmea = new NmeaAnemometer(link);

  private Anemometer.Wind heard(String sentence) {
    link.fromDevice(Nmea.bytes(sentence));
    return nmea.read(1).orElseThrow();
  }

  @Test
  void read_sentenceOfAnAirmar_isRead() {
    link.fromDevice("$IIMWV,084.0,R,10.4,N,A*04\r\n".getBytes(US_ASCII));

    Anemometer.Wind wind = nmea.read(1).orElseThrow();

    assertThat(wind.speedMps()).isCloseTo(5.350, within(0.001));
    assertThat(Math.toDegrees(wind.fromRad())).as("from the right").isCloseTo(-84.0, within(1e-9));
  }

  @ParameterizedTest
  @CsvSource({"36.0, K, 10.0", "10.0, M, 10.0", "22.369, S, 10.0", "19.438, N, 10.0"})
  void read_anyUnit_isMetresPerSecond(String speed, String unit, double mps) {
    assertThat(heard("WIMWV,0.0,R," + speed + "," + unit + ",A").speedMps())
        .isCloseTo(mps, within(0.001));
  }

  @ParameterizedTest
  @ValueSource(strings = {"WIMWV,10.0,T,5.0,M,A", "WIMWV,10.0,R,5.0,M,V", "WIMWV,10.0,R,,M,V"})
  void read_trueWindOrInvalid_isIgnored(String sentence) {
    heard("WIMWV,20.0,R,3.0,M,A");

    assertThat(heard(sentence).speedMps()).isEqualTo(3.0);
    assertThat(nmea.malformed()).isZero();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "WIMWV,361.0,R,5.0,M,A | angle 361.0 is outside 0…360.0",
        "WIMWV,1.0,R,-5.0,M,A | speed -5.0 is outside 0…200.0",
        "WIMWV,1.0,R,5.0,X,A | unit of speed \"X\": expected M, N, K or S",
        "WIMWV,1.0,R,NaN,M,A | speed NaN is outside 0…200.0",
      })
  void read_absurdValue_isRefusedByName(String sentence, String reason) {
    heard("WIMWV,20.0,R,3.0,M,A");

    assertThat(heard(sentence).speedMps()).isEqualTo(3.0);
    assertThat(nmea.lastRefusal()).startsWith(reason);
  }
}
