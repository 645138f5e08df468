package org.u2sa.drivers.link;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.SystemClock;

/** What a user mistypes is said in one line that quotes it. */
class ByteLinksTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "/dev/ttyUSB0 | expected serial:PATH?baud=N, tcp:HOST:PORT, udp:PORT, udp:HOST:PORT or replay:FILE",
        "serail:/dev/ttyUSB0 | unknown kind \"serail\"; expected serial:PATH?baud=N, tcp:HOST:PORT, udp:PORT, udp:HOST:PORT or replay:FILE",
        "serial: | expected serial:PATH?baud=N, tcp:HOST:PORT, udp:PORT, udp:HOST:PORT or replay:FILE",
        "serial:COM3?baud=fast | option \"baud\": \"fast\"; expected 1…4000000",
        "serial:COM3?baud=0 | option \"baud\": 0 is outside 1…4000000",
        "serial:COM3?bauds=9600 | unknown option \"bauds\"; known for serial: [baud, dtr, parity, record, stop]",
        "serial:COM3?baud | option \"baud\" is not NAME=VALUE",
        "serial:COM3?dtr=no | option \"dtr\": \"no\" is neither on nor off",
        "serial:COM3?parity=mark | option \"parity\": \"mark\" is not none, even or odd",
        "tcp:4001 | no host; expected tcp:HOST:PORT",
        "tcp:gps:70000 | port: 70000 is outside 1…65535",
        "tcp:gps:nmea | port: \"nmea\"; expected 1…65535",
        "udp:0 | port: 0 is outside 1…65535",
        "udp:10110?silence=-1 | option \"silence\": -1 is outside 0.0…3600.0"
      })
  void open_badAddress_isRefusedWithWhatWasExpected(String address, String why) {
    assertThatThrownBy(() -> ByteLinks.open(address, new SystemClock()))
        .isInstanceOf(BadInputException.class)
        .hasMessage("link address \"" + address + "\": " + why);
  }
}
