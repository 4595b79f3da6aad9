#include "golden_device.h"

int main(void)
{
    golden_run(&golden_slices);
    return 0;
}
