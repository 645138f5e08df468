/**
 * What a flight leaves behind: its track, its score against the mission by truth, and the files
 * that tell of both. Independent of any simulator and of how the vehicle was controlled; talking to
 * terminals is not here.
 */
package org.u2sa.scenarios.report;
