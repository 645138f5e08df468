package org.u2sa.world.coverage;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Variables of the modeller {@code COVERAGE}. */
record CoverageVariables(
    @Variable(unit = "m", min = 0.5, max = 100, ifAbsent = 5)
        @Description("Side of the cells into which search areas are divided.")
        double coverageCell,
    @Variable(unit = "m", min = 0, max = 50, ifAbsent = 2)
        @Description(
            "Margin by which the ground that an image shows is reduced on all sides, for errors of the vehicle's position and attitude.")
        double coverageMargin) {}
