/** Where a vehicle returns to, and by which way within the fence. */
package org.u2sa.mission.returning;
