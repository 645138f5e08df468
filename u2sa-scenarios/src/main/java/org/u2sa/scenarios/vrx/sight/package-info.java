/** Gates and signs recognised from detected objects. */
package org.u2sa.scenarios.vrx.sight;
