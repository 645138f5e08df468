package org.u2sa.fuzz;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.flightgear.protocol.InLine;
import org.u2sa.flightgear.protocol.LineSplitter;
import org.u2sa.flightgear.protocol.MalformedLineException;
import org.u2sa.flightgear.protocol.OutLine;

/** Bytes on FlightGear's sockets, in one packet and in two. */
public final class FlightGearLineTarget {
  private FlightGearLineTarget() {}

  /** Called by the fuzzer. */
  public static void fuzzerTestOneInput(byte[] data) {
    List<String> whole = split(data, data.length);
    List<String> halves = split(data, data.length / 2);
    Agreement.require(whole.equals(halves), "lines of two packets", halves, whole);
    InLine told = InLine.nothing();
    for (String line : whole) {
      try {
        OutLine read = OutLine.parse(line);
        Agreement.require(!read.format().isEmpty(), "line", read, line);
      } catch (MalformedLineException e) {
        Agreement.require(!e.getMessage().isEmpty(), "reason", e.getMessage(), "a sentence");
      }
      try {
        told = told.after(line);
        InLine again = InLine.nothing().after(told.format());
        Agreement.require(again.count() == told.count(), "count", again, told);
      } catch (MalformedLineException e) {
        Agreement.require(!e.getMessage().isEmpty(), "reason", e.getMessage(), "a sentence");
      }
    }
  }

  private static List<String> split(byte[] data, int cut) {
    List<String> lines = new ArrayList<>();
    LineSplitter splitter = new LineSplitter();
    splitter.feed(ByteBuffer.wrap(data, 0, cut), lines::add, lines::add);
    splitter.feed(ByteBuffer.wrap(data, cut, data.length - cut), lines::add, lines::add);
    return lines;
  }
}
