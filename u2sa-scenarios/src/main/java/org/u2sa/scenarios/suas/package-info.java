/**
 * The SUAS demo: field, mission, camera and judge. Formulas of the score belong in {@code score}.
 */
package org.u2sa.scenarios.suas;
