package org.u2sa.planning.survey;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Camera parameters used by the planner of search areas, and settings for laying lanes. */
public record SurveyVariables(
    @Variable(min = 10, max = 100_000, ifAbsent = 1000)
        @Description("Focal length of the downward-looking camera, in pixels.")
        double surveyFocalLength,
    @Variable(min = 10, max = 100_000, ifAbsent = 1000)
        @Description("Pixels across the direction of flight.")
        double surveyPixels,
    @Variable(min = 0, max = 0.9, ifAbsent = 0.3)
        @Description("Overlap of neighbouring lanes, as a share of the width that an image shows.")
        double surveyOverlap,
    @Variable(min = 0.1, max = 1, ifAbsent = 0.8)
        @Description(
            "Height of flight, as a share of the height at which a level image has the required resolution.")
        double surveyHeight,
    @Variable(unit = "m", min = 0, max = 1000, ifAbsent = 40)
        @Description("Straight way before each lane, to become level and settle on its line.")
        double surveyLeadIn,
    @Variable(min = 1, max = 50, ifAbsent = 8)
        @Description("Number of passes over missing parts before the goal is given up.")
        int surveyPasses,
    @Variable(min = 0.01, max = 1, ifAbsent = 0.1)
        @Description("Slope of climbs and descents that follow TERRAIN.")
        double surveyClimb,
    @Variable(ifAbsentText = "")
        @Description(
            "Height map of the ground, an Esri ASCII grid in degrees; without it, and outside it, search areas are level, and routes ignore the ground.")
        String terrain) {}
