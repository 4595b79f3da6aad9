#include "golden_device.h"

int main(void)
{
    return golden_run(&golden_preweighted);
}
