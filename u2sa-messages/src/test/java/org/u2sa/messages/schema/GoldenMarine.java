package org.u2sa.messages.schema;

import org.u2sa.messages.marine.Bin;
import org.u2sa.messages.marine.Buoy;
import org.u2sa.messages.marine.Button;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.marine.HotTarget;
import org.u2sa.messages.marine.PathMarker;
import org.u2sa.messages.marine.Pole;
import org.u2sa.messages.marine.Puck;

/** Objects of surface and underwater courses. */
final class GoldenMarine {
  private GoldenMarine() {}

  static void addTo(GoldenMessages golden) {
    golden.add("Buoy", GoldenWorld.seen(new Buoy().radius(0.25).colour(Colour.RED)));
    golden.add(
        "Hoop",
        GoldenWorld.seen(
            new Hoop().radius(0.5).thickness(0.03125).psi(0.75).lying(true).colour(Colour.BLUE)));
    golden.add(
        "HotTarget",
        GoldenWorld.seen(
            new HotTarget()
                .length(0.03125)
                .width(0.5)
                .height(0.5)
                .psi(0.75)
                .excessTemperature(12.5)));
    golden.add(
        "Puck", GoldenWorld.seen(new Puck().radius(0.0381).height(0.0254).colour(Colour.BLACK)));
    golden.add(
        "Button",
        GoldenWorld.seen(
            new Button().length(0.0625).width(0.25).height(0.25).psi(0.75).colour(Colour.WHITE)));
    golden.add(
        "Dock",
        GoldenWorld.seen(
            new Dock()
                .length(3.0)
                .width(2.5)
                .height(0.5)
                .thickness(0.5)
                .psi(0.75)
                .colour(Colour.GREEN)));
    golden.add(
        "Bin",
        GoldenWorld.seen(
            new Bin().length(0.5).width(0.25).height(0.125).psi(0.75).colour(Colour.BLACK)));
    golden.add(
        "PathMarker",
        GoldenWorld.seen(
            new PathMarker().length(1.25).width(0.125).psi(0.75).colour(Colour.ORANGE)));
    golden.add(
        "Pole", GoldenWorld.seen(new Pole().radius(0.0625).height(2.0).colour(Colour.GREEN)));
  }
}
