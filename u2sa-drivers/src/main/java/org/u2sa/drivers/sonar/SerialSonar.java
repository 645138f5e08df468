package org.u2sa.drivers.sonar;

import org.u2sa.device.port.RangeFinder;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteParser;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.ParsedDevice;

/** A free-running MaxBotix sonar on a link. */
public final class SerialSonar extends ParsedDevice<RangeFinder.Distance> implements RangeFinder {
  public SerialSonar(ByteLink link, SonarModel model) {
    super(link, new SonarParser(model));
  }

  /** Provider of MODEL = LV, XL and HR. */
  public static final class Provider extends LinkProvider<RangeFinder> {
    public Provider() {
      super(
          RangeFinder.class,
          (name, link) -> new SerialSonar(link, SonarModel.valueOf(name)),
          "LV",
          "XL",
          "HR");
    }
  }

  /** Parses a MaxBotix sonar's serial output: "R", digits, carriage return. */
  static final class SonarParser extends ByteParser<RangeFinder.Distance> {
    private static final int CARRIAGE_RETURN = '\r';
    private static final int BEGIN = 'R';

    private final SonarModel model;
    private int digits = -1; // digits since the R; -1 before an R
    private int count;

    /** Creates a parser for a sonar family. */
    SonarParser(SonarModel model) {
      this.model = model;
    }

    @Override
    public void accept(byte[] bytes, int length, long nowMicros) {
      for (int i = 0; i < length; i++) {
        accept(bytes[i] & 0xFF, nowMicros);
      }
    }

    private void accept(int each, long nowMicros) {
      if (each == BEGIN) {
        if (digits >= 0) {
          refuse(); // a partial message was interrupted
        }
        digits = 0;
        count = 0;
      } else if (each >= '0' && each <= '9' && digits >= 0 && digits < model.digits()) {
        digits++;
        count = 10 * count + each - '0';
      } else if (each == CARRIAGE_RETURN && digits == model.digits()) {
        found(new RangeFinder.Distance(nowMicros, model.rangeM(count)));
        digits = -1;
      } else {
        refuse();
        digits = -1;
      }
    }

    private void refuse() {
      refuse("not R, " + model.digits() + " digits and a carriage return");
    }

    @Override
    public void reset() {
      digits = -1;
    }
  }
}
