package org.u2sa.sim.ioio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Bytes by hand, after protocol_defs.h of the firmware. */
class IoioFirmwareTest {
  private static final double HALF_TICK_S = 0.25e-6; // of 2 MHz

  private final Bench bench = new Bench();

  @Test
  void open_powered_saysWhoItIs() {
    bench.firmware.open();
    assertThat(bench.answer())
        .isEqualTo(
            "00 49 4f 49 4f 53 50 52 4b 30 30 32 30 49 4f 49 4f 30 34 30 32 49 4f 49 4f 30 35 30 36");
  }

  @Test
  void checkInterface_known_isSupportedAndUnknownIsNot() {
    bench.open().send(2, 'I', 'O', 'I', 'O', '0', '0', '0', '5');
    assertThat(bench.answer()).isEqualTo("02 01");
    bench.send(2, 'I', 'O', 'I', 'O', '0', '9', '0', '0');
    assertThat(bench.answer()).isEqualTo("02 00");
  }

  @Test
  void digitalOut_levels_showAtThePin() {
    bench.open().send(3, 12 << 2 | 2);
    assertThat(bench.levels).containsEntry(12, true);
    bench.send(4, 12 << 2);
    assertThat(bench.levels).containsEntry(12, false);
    bench.send(5, 12 << 2);
    assertThat(bench.levels).doesNotContainKey(12);
  }

  @Test
  void pwm_50HzOf1500us_isThatPulseAtThePin() {
    // 16 MHz / 8 = 2 MHz: 40000 clocks of period, 3000 of pulse; both registers hold one less
    bench.open().send(3, 10 << 2).send(8, 10, 0x80 | 2).send(0x0A, 0x80 | 2 << 1 | 1, 0x3F, 0x9C);
    assertThat(bench.driven.get(10).widthS()).as("before the first duty cycle").isZero();
    bench.send(9, 2 << 2, 2999 & 0xFF, 2999 >> 8);
    assertThat(bench.driven.get(10).widthS()).isCloseTo(1.5e-3, within(1.0e-12));
    assertThat(bench.driven.get(10).periodS()).isCloseTo(0.02, within(1.0e-12));
    bench.send(9, 2 << 2 | 1, 2999 & 0xFF, 2999 >> 8);
    assertThat(bench.driven.get(10).widthS()).isCloseTo(1.5e-3 + HALF_TICK_S / 2, within(1.0e-12));
  }

  @Test
  void pwm_pinWithoutPeripheral_staysADigitalOutput() {
    bench.open().send(3, 20 << 2).send(8, 20, 0x80).send(0x0A, 0x81, 0x3F, 0x9C).send(9, 0, 9, 9);
    assertThat(bench.driven).doesNotContainKey(20);
    assertThat(bench.levels).containsEntry(20, false);
  }

  @Test
  void uart_bytesBothWays_takeTheirTimeOnTheLine() {
    bench.open().send(5, 6 << 2).send(0x0F, 6, 0x80).send(3, 7 << 2 | 2).send(0x0F, 7, 0xC0);
    bench.send(0x0D, 0x08, 416 & 0xFF, 416 >> 8); // 4 MHz / 417 = 9592 baud
    assertThat(bench.answer()).isEqualTo("0d 80 0f 00 04"); // open, 256 bytes of room

    bench.device = "ab".getBytes(StandardCharsets.US_ASCII);
    bench.advance(0.001);
    assertThat(bench.answer()).isEmpty(); // a byte takes 1.04 ms
    bench.advance(0.003);
    assertThat(bench.answer()).isEqualTo("0e 00 61 0e 00 62");

    bench.send(0x0E, 1, 'h', 'i').advance(0.004);
    assertThat(bench.sent.get(7).toString(StandardCharsets.US_ASCII)).isEqualTo("hi");
    assertThat(bench.baud).as("what a device of 9600 baud understands").isEqualTo(9600);
  }

  @Test
  void uart_moreThanHalfOfItsRoomSent_saysSo() {
    bench.open().send(3, 7 << 2 | 2).send(0x0F, 7, 0xC0).send(0x0D, 0x08, 9, 0); // 400 kbaud
    bench.answer();
    for (int packet = 0; packet < 3; packet++) {
      byte[] message = new byte[66];
      message[0] = 0x0E;
      message[1] = 63;
      bench.firmware.accept(message, 0, message.length);
    }
    bench.advance(0.02);
    // 40 bytes a millisecond: reported when more than 128 are gone, 160, and the rest not
    assertThat(bench.answer()).isEqualTo("0f 80 02");
    assertThat(bench.sent.get(7).size()).isEqualTo(192);
  }

  @Test
  void analog_twoPins_formatOnceThenValues() {
    bench.volts.put(40, 1.65);
    bench.volts.put(31, 9.9);
    bench.open().send(0x0B, 40).send(0x0C, 0x80 | 40).send(0x0B, 31).send(0x0C, 0x80 | 31);
    bench.advance(0.002);
    // channel 5 is pin 31 and full, 3ff; channel 9 is pin 40 at 200
    assertThat(bench.answer()).isEqualTo("0c 02 1f 28 0b 03 ff 80 0b 03 ff 80");
    bench.send(0x0C, 40).send(0x0C, 31);
    assertThat(bench.answer()).isEqualTo("0c 00");
  }

  @Test
  void pulseIn_servoPulses_areMeasuredEach() {
    bench.pulses.put(35, new PulseTrain(1.5e-3, 0.02));
    bench.open().send(5, 35 << 2).send(0x1C, 35, 0x80).send(0x1B, 0, 0x80 | 1 << 3);
    assertThat(bench.answer()).isEqualTo("1b 80");
    bench.advance(0.065); // rising edges at 20, 40 and 60 ms
    assertThat(bench.answer()).isEqualTo("1c 80 c0 5d 1c 80 c0 5d 1c 80 c0 5d"); // 24000 of 16 MHz
    bench.pulses.clear();
    bench.advance(0.1);
    assertThat(bench.answer()).isEmpty();
  }

  @Test
  void pulseIn_frequencyOfSixteenPeriods_isMeasured() {
    bench.pulses.put(35, new PulseTrain(1.0e-5, 1.0e-4));
    bench.open().send(5, 35 << 2).send(0x1C, 35, 0x82).send(0x1B, 2, 5 << 3 | 1);
    bench.answer();
    bench.advance(0.008);
    assertThat(bench.answer()).isEqualTo("1c 82 80 0c"); // 3200 of 2 MHz
  }

  @Test
  void changeNotify_input_reportsNowAndAtChanges() {
    bench.inputs.put(3, true);
    bench.open().send(5, 3 << 2).send(6, 3 << 2 | 1).advance(0.01);
    bench.inputs.put(3, false);
    bench.advance(0.01).send(6, 3 << 2);
    assertThat(bench.answer()).isEqualTo("06 0d 04 0d 04 0c 06 0c");
  }

  @Test
  void softReset_pwm_floatsAndEchoes() {
    bench.open().send(3, 10 << 2).send(8, 10, 0x80).send(0x0A, 0x81, 0x3F, 0x9C).send(9, 0, 9, 9);
    bench.send(1);
    assertThat(bench.answer()).isEqualTo("01");
    assertThat(bench.driven).isEmpty();
    assertThat(bench.firmware.isOpen()).isTrue();
  }

  @Test
  void softClose_queuedBytes_areSentBeforeTheEnd() {
    bench.open().send(0x23, 0x1D);
    assertThat(bench.firmware.isOpen()).isTrue();
    assertThat(bench.answer()).isEqualTo("23 1d");
    assertThat(bench.firmware.isOpen()).isFalse();
    assertThat(bench.firmware.trouble()).isEmpty();
  }

  @Test
  void lost_pwm_floats() {
    bench.open().send(3, 10 << 2).send(8, 10, 0x80).send(0x0A, 0x81, 0x3F, 0x9C).send(9, 0, 9, 9);
    assertThat(bench.driven).containsKey(10);
    bench.firmware.lost();
    assertThat(bench.driven).isEmpty();
    assertThat(bench.levels).containsOnlyKeys(0); // the LED's pin, off
  }

  @ParameterizedTest
  @CsvSource({
    "unknown type, 36",
    "reserved type, 21",
    "type that the firmware knows no longer, 7 0 0",
    "no such pin, 3 188",
    "no such pull mode, 5 11",
    "no such PWM module, 8 10 137",
    "no such capture, 28 35 137",
    "half of a pair, 27 1 136",
    "no such parity, 13 3 9 0",
    "hard reset, 0 73 79 73 79",
    "hard reset by accident, 0 1 2 3 4",
    "after the soft close, 29 35"
  })
  void accept_whatTheBoardDoesNotTake_endsTheConnection(String what, String bytes) {
    bench.open().send(3, 10 << 2).send(8, 10, 0x80).send(0x0A, 0x81, 0x3F, 0x9C).send(9, 0, 9, 9);
    for (String octet : bytes.split(" ")) {
      bench.send(Integer.parseInt(octet));
    }
    assertThat(bench.firmware.isOpen()).as(what).isFalse();
    assertThat(bench.firmware.trouble()).isNotEmpty();
    assertThat(bench.driven).isEmpty();
    bench.firmware.open();
    assertThat(bench.answer()).startsWith("00 49 4f 49 4f");
  }

  @Test
  void accept_oneByteAtATime_answersTheSame() {
    int[] session = {
      2, 'I', 'O', 'I', 'O', '0', '0', '0', '5', 3, 10 << 2, 8, 10, 0x80, 0x0A, 0x81, 0x3F, 0x9C, 9,
      0, 9, 9, 0x23, 0x0D, 0x08, 9, 0, 0x0E, 2, 1, 2, 3
    };
    bench.open().send(session);
    String whole = bench.answer();
    Bench other = new Bench().open();
    for (int octet : session) {
      other.send(octet);
    }
    assertThat(other.answer()).isEqualTo(whole).isEqualTo("02 01 23 0d 80 0f 00 04");
    assertThat(other.driven).isEqualTo(bench.driven);
  }

  @Test
  void output_hostThatDoesNotRead_losesWhatDoesNotFit() {
    bench.open().send(0x0B, 40).send(0x0C, 0x80 | 40).advance(60.0);
    assertThat(bench.answer().length()).isLessThanOrEqualTo(3 * 8192);
  }
}
