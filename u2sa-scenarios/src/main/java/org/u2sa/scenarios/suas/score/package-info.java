/** The competition's formulas, on plain numbers. What happened in a run belongs to the judge. */
package org.u2sa.scenarios.suas.score;
