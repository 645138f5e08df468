/** Numbers with units, as files and configuration write them. */
package org.u2sa.interfaces.units;
